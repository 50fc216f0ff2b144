# The CMake package LambertLab, for programs outside this tree: installed under any prefix, and from the build tree itself.
# SPDX-License-Identifier: MIT
include(CMakePackageConfigHelpers)

set(package_targets project_options three lighting image render lab)
install(TARGETS ${package_targets} EXPORT LambertLabTargets DESTINATION lib/lambert-lab)
install(EXPORT LambertLabTargets NAMESPACE LambertLab:: DESTINATION lib/cmake/LambertLab)
export(EXPORT LambertLabTargets NAMESPACE LambertLab:: FILE ${PROJECT_BINARY_DIR}/LambertLabTargets.cmake)
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION include/lambert-lab FILES_MATCHING PATTERN "*.hpp")
add_library(LambertLab::lab ALIAS lab)  # the same name where this whole tree is a part of another

# One text for both places; all that differs is where bin/, lib/ and share/ are.
set(home_from_here .)
configure_file(lab/LambertLabConfig.cmake.in ${PROJECT_BINARY_DIR}/LambertLabConfig.cmake @ONLY)
set(home_from_here ../../..)
configure_file(lab/LambertLabConfig.cmake.in ${PROJECT_BINARY_DIR}/installed/LambertLabConfig.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/LambertLabConfigVersion.cmake COMPATIBILITY SameMinorVersion)
configure_file(lab/say_home.cpp ${PROJECT_BINARY_DIR}/say_home.cpp COPYONLY)
install(FILES ${PROJECT_BINARY_DIR}/installed/LambertLabConfig.cmake ${PROJECT_BINARY_DIR}/LambertLabConfigVersion.cmake
    lab/say_home.cpp DESTINATION lib/cmake/LambertLab)
