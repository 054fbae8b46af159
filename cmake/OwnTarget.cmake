# SPDX-License-Identifier: GPL-3.0-or-later
# own_target(<target>): what every target with own sources gets: warnings, ccache, few compilers at a time.
# share_headers(<target>): precompiles CGAL's basic headers with the library, once, for all targets that call this.
#   Measured with g++ 12: 12 s for a small file without, 2 s with; 25 s and 460 MB of disk for the header itself.

option(CGAL_BLEND_PRECOMPILED_HEADER "Precompile CGAL's basic headers" ${PROJECT_IS_TOP_LEVEL})

add_library(cgal_blend_options INTERFACE)
target_compile_options(cgal_blend_options INTERFACE -Wall -Wextra
  $<$<BOOL:${CGAL_BLEND_WARNINGS_AS_ERRORS}>:-Werror>
  -fPIC)  # everywhere alike, or the precompiled header cannot be shared

set_property(GLOBAL APPEND PROPERTY JOB_POOLS cgal_blend_compile=${CGAL_BLEND_COMPILE_JOBS})

find_program(CGAL_BLEND_CCACHE ccache DOC "Compiler cache")
mark_as_advanced(CGAL_BLEND_CCACHE)
if(CGAL_BLEND_CCACHE)
  # What ccache asks for to work with precompiled headers.
  set(ccache_launcher "${CMAKE_COMMAND}" -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${CGAL_BLEND_CCACHE}")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(cgal_blend_options INTERFACE -fpch-preprocess)
  endif()
endif()

function(own_target target)
  # BUILD_INTERFACE: these options are not part of what is installed.
  target_link_libraries(${target} PRIVATE "$<BUILD_INTERFACE:cgal_blend_options>")
  set_target_properties(${target} PROPERTIES JOB_POOL_COMPILE cgal_blend_compile)
  if(CGAL_BLEND_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "${ccache_launcher}")
  endif()
endfunction()

function(share_headers target)
  if(NOT CGAL_BLEND_PRECOMPILED_HEADER)
    return()
  elseif(target STREQUAL "cgal_blend")
    target_precompile_headers(cgal_blend PRIVATE
      <CGAL/Exact_predicates_inexact_constructions_kernel.h> <CGAL/Surface_mesh.h>
      <algorithm> <array> <cmath> <map> <optional> <string> <unordered_map> <vector>)
  else()
    target_precompile_headers(${target} REUSE_FROM cgal_blend)
  endif()
endfunction()
