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

# A compiler cache, where there is one, takes sources with a precompiled header only so.
list(PREPEND CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_SLOPPINESS=pch_defines,time_macros)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)
endif()

# The sources that <folder>/Make/files lists, with their path.
function(listSources variable folder)
    file(STRINGS ${folder}/Make/files sources REGEX "^[A-Za-z0-9_/]+[.]cpp")
    string(REGEX REPLACE "[ \t]+(;|$)" "\\1" sources "${sources}")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${folder}/Make/files)
    list(TRANSFORM sources PREPEND ${folder}/)
    set(${variable} ${sources} PARENT_SCOPE)
endfunction()

# Headers that the compiler reads once for all sources that include them: those of nscd serve every target of the core. The kernels
# for wider instruction sets are each compiled on their own, nothing read before they say for which set.
function(precompileHeaders name)
    if(name STREQUAL nscd)
        target_precompile_headers(nscd PRIVATE ${root}/etc/precompiled/coreHeaders.hpp)
        file(GLOB kernels ${root}/src/nscd/kernels/sweepKernel*.cpp)
        set_source_files_properties(${kernels} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    else()
        target_precompile_headers(${name} REUSE_FROM nscd)
    endif()
endfunction()

# A library of the core from the one list of its sources, src/<name>/Make/files.
function(addCoreLibrary name)
    listSources(sources ${root}/src/${name})
    if(sources)
        add_library(${name} STATIC ${sources})
        target_include_directories(${name} PUBLIC ${root}/src)
        target_link_libraries(${name} PUBLIC Eigen3::Eigen)
        precompileHeaders(${name})
    endif()
endfunction()
