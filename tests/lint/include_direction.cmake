# The arrows between the folders of the generator run one way: a folder includes its own headers, and
# those of the folders that are named for it here.
#
#   cmake -DGENERATOR=generator -P tests/lint/include_direction.cmake
cmake_minimum_required(VERSION 3.25)

set(base)
set(report base)
set(lesson report base)
set(course lesson report base)
set(physics report base)
set(script physics report base)
set(evaluate course lesson physics script report base)
set(page evaluate course lesson script report base) # what physics found comes in evaluate's results
set(preview page evaluate course lesson physics script report base)
set(lsp preview evaluate course lesson physics script report base)
set(cli lsp preview page evaluate course lesson physics script report base)
set(main cli base)
set(folders base report lesson course physics script evaluate page preview lsp cli)

set(wrong 0)
set(checked 0)
file(GLOB_RECURSE sources RELATIVE ${GENERATOR} ${GENERATOR}/*.h ${GENERATOR}/*.cpp ${GENERATOR}/*.c)
foreach(source IN LISTS sources)
  string(REGEX MATCH "^[^/]+" folder ${source})
  if(folder STREQUAL source) # main.cpp
    set(folder main)
  elseif(NOT folder IN_LIST folders)
    message("${source}: there is no rule for the folder ${folder}")
    math(EXPR wrong "${wrong} + 1")
    continue()
  endif()
  file(STRINGS ${GENERATOR}/${source} includes REGEX "^ *# *include *[\"<]")
  foreach(include IN LISTS includes)
    if(NOT include MATCHES "[\"<]([a-z_]+)/" OR NOT CMAKE_MATCH_1 IN_LIST folders)
      continue() # of the system
    endif()
    math(EXPR checked "${checked} + 1")
    if(NOT CMAKE_MATCH_1 STREQUAL folder AND NOT CMAKE_MATCH_1 IN_LIST ${folder})
      message("${source}: ${folder} may not include ${CMAKE_MATCH_1}: ${include}")
      math(EXPR wrong "${wrong} + 1")
    endif()
  endforeach()
endforeach()

if(wrong GREATER 0)
  message(FATAL_ERROR "${wrong} includes against the arrows")
elseif(checked EQUAL 0)
  message(FATAL_ERROR "no includes were found below ${GENERATOR}")
endif()
message("${checked} includes, all along the arrows")
