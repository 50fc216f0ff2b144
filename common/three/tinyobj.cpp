// tinyobjloader's code, compiled into this library: a shared library would be loaded by every lesson, needed or not.
// SPDX-License-Identifier: MIT
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
