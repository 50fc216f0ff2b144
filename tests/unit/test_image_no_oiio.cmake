# What links `image` loads OpenImageIO for .tif and for nothing else, and says so where its module is missing.
# SPDX-License-Identifier: MIT
# Run as: cmake -DPROGRAM=path of test_image_plain -DDIRECTORY=a scratch directory -P this file
file(REMOVE_RECURSE ${DIRECTORY})
file(MAKE_DIRECTORY ${DIRECTORY})

function(expect CONDITION)
    if(NOT (${ARGN}))
        message(FATAL_ERROR "${CONDITION}; found: ${found}")
    endif()
endfunction()

# What the dynamic loader says while PROGRAM writes the given files.
function(libraries_while_writing)
    list(TRANSFORM ARGN PREPEND ${DIRECTORY}/ OUTPUT_VARIABLE paths)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env LD_DEBUG=libs ${PROGRAM} ${paths}
        ERROR_VARIABLE found RESULT_VARIABLE status)
    expect("writing ${ARGN} should succeed, status ${status}" status EQUAL 0)
    set(found "${found}" PARENT_SCOPE)
endfunction()

execute_process(COMMAND ldd ${PROGRAM} OUTPUT_VARIABLE found COMMAND_ERROR_IS_FATAL ANY)
expect("ldd should list libpng" found MATCHES "libpng")
expect("ldd should list no OpenImageIO" NOT found MATCHES "OpenImageIO|lambert_image_oiio")

libraries_while_writing(a.png a.exr)
expect("the loader should report OpenEXR" found MATCHES "libOpenEXR")
expect("PNG and EXR should not load OpenImageIO" NOT found MATCHES "OpenImageIO|lambert_image_oiio")

libraries_while_writing(a.tif)
expect("TIFF should load the module and OpenImageIO" found MATCHES "lambert_image_oiio.*OpenImageIO")

# A copy that does not find lib/ beside itself.
file(COPY ${PROGRAM} DESTINATION ${DIRECTORY}/bin)
get_filename_component(name ${PROGRAM} NAME)
execute_process(COMMAND ${DIRECTORY}/bin/${name} ${DIRECTORY}/b.tif
    ERROR_VARIABLE found RESULT_VARIABLE status)
expect("without the module TIFF should fail with status 5, not ${status}" status EQUAL 5)
expect("the message should name the module"
    found MATCHES "b.tif.*liblambert_image_oiio.so.*write .png, .exr or .pfm")

file(GLOB left RELATIVE ${DIRECTORY} ${DIRECTORY}/* ${DIRECTORY}/.lambert*)
list(JOIN left " " found)
expect("only what was written should be left" found STREQUAL "a.exr a.png a.tif bin")
