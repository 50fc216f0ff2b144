// Includes a file of the grader's, to read it in the error message.
// SPDX-License-Identifier: MIT
#include "hostile.hpp"

#include SECRET_FILE

int main() {}
