# SPDX-License-Identifier: GPL-3.0-or-later
# SPDX-FileCopyrightText: 2026 The nscdDEMFoam authors
# What CMake builds of ours share: root of the sources, compiler flags, and the core's libraries from their lists of sources.

get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
find_package(Eigen3 REQUIRED NO_MODULE)

# The flags of etc/wmakeFlags, so that both builds are alike.
file(STRINGS ${root}/etc/wmakeFlags coreFlags REGEX "^CORE_FLAGS")
string(REGEX REPLACE "^CORE_FLAGS *= *| *[$][(]EIGEN_INC[)]" "" coreFlags "${coreFlags}")
separate_arguments(coreFlags)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${root}/etc/wmakeFlags)
add_compile_options(${coreFlags})

# The sources that <folder>/Make/files lists, with their path.
function(listSources variable folder)
    file(STRINGS ${folder}/Make/files sources REGEX "^[A-Za-z0-9_/]+[.]cpp")
    string(REGEX REPLACE "[ \t]+(;|$)" "\\1" sources "${sources}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/Make/files)
    list(TRANSFORM sources PREPEND ${folder}/)
    set(${variable} ${sources} PARENT_SCOPE)
endfunction()

# A library of the core from the one list of its sources, src/<name>/Make/files.
function(addCoreLibrary name)
    listSources(sources ${root}/src/${name})
    if(sources)
        add_library(${name} STATIC ${sources})
        target_include_directories(${name} PUBLIC ${root}/src)
        target_link_libraries(${name} PUBLIC Eigen3::Eigen)
    endif()
endfunction()
