# SPDX-License-Identifier: GPL-3.0-or-later
# own_target(<target>): what every target with own sources gets: warnings, ccache, few compilers at a time.

add_library(cgal_blend_warnings INTERFACE)
target_compile_options(cgal_blend_warnings INTERFACE -Wall -Wextra
  $<$<BOOL:${CGAL_BLEND_WARNINGS_AS_ERRORS}>:-Werror>)

find_program(CGAL_BLEND_CCACHE ccache DOC "Compiler cache; empty: none")
mark_as_advanced(CGAL_BLEND_CCACHE)

set_property(GLOBAL APPEND PROPERTY JOB_POOLS cgal_blend_compile=${CGAL_BLEND_COMPILE_JOBS})

function(own_target target)
  # BUILD_INTERFACE: the warnings are not part of what is installed.
  target_link_libraries(${target} PRIVATE "$<BUILD_INTERFACE:cgal_blend_warnings>")
  set_target_properties(${target} PROPERTIES JOB_POOL_COMPILE cgal_blend_compile)
  if(CGAL_BLEND_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set_target_properties(${target} PROPERTIES CXX_COMPILER_LAUNCHER "${CGAL_BLEND_CCACHE}")
  endif()
endfunction()
