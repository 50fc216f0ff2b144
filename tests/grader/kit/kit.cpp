// The kit's own line of code: its library is made of the lab's, and a library needs a source.
// SPDX-License-Identifier: MIT

extern "C" const char* lambertLabKit();

/// The lab's version, for whoever finds the library.
const char* lambertLabKit() { return LAMBERT_VERSION; }
