# What computes results, for their keys: hashes of the sources of some folders. Comments do not count.
# Used by generator/CMakeLists.txt, and run as a script for the hash of one folder (FOLDER_HASH) and for
# that of several (HEADER).
if(DEFINED FOLDER_HASH)
  # The preprocessor reads C++ as the compiler does. Told that all is preprocessed already, it leaves
  # comments out, and directives as they are.
  execute_process(
    COMMAND ${PREPROCESSOR} -fpreprocessed -dD -E -P -w -x c++ ${SOURCES}
    OUTPUT_VARIABLE text
    COMMAND_ERROR_IS_FATAL ANY)
  string(SHA256 hash "${SOURCES}\n${text}")
  file(CONFIGURE OUTPUT ${FOLDER_HASH} CONTENT "${hash}" @ONLY)
  return()
elseif(DEFINED HEADER)
  set(hashes "")
  foreach(file IN LISTS FOLDER_HASHES)
    file(READ ${file} hash)
    string(APPEND hashes "${hash}\n")
  endforeach()
  string(SHA256 all "${hashes}")
  string(SUBSTRING ${all} 0 16 all)
  # Left alone where it says that already, so that nothing is compiled again.
  file(CONFIGURE OUTPUT ${HEADER} CONTENT "#pragma once\ninline constexpr const char* ${NAME} = \"${all}\";\n" @ONLY)
  return()
endif()

find_program(preprocessor g++ REQUIRED)

# The file with the hash of `folder`.
function(folder_hash folder into)
  string(REPLACE / _ name ${folder})
  set(hash ${CMAKE_CURRENT_BINARY_DIR}/sources/${name}.hash)
  set(${into} ${hash} PARENT_SCOPE)
  get_property(is_known SOURCE ${hash} PROPERTY GENERATED)
  if(is_known)
    return()
  endif()
  set(patterns ${folder}/*.cpp ${folder}/*.h ${folder}/*.hpp ${folder}/*.c)
  file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${patterns})
  add_custom_command(
    OUTPUT ${hash}
    COMMAND ${CMAKE_COMMAND} "-DSOURCES=${sources}" -DFOLDER_HASH=${hash} -DPREPROCESSOR=${preprocessor}
            -P ${CMAKE_CURRENT_SOURCE_DIR}/sources_hash.cmake
    DEPENDS ${sources} sources_hash.cmake
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    VERBATIM)
endfunction()

# The constant NAME, for sources of TARGET by "sources/NAME.h": a hash of the folders given and of all
# that they may include (arrows.cmake), and of the folders ALONE.
function(sources_hash target name)
  cmake_parse_arguments(PARSE_ARGV 2 hash "" "" ALONE)
  set(reached ${hash_UNPARSED_ARGUMENTS})
  foreach(folder IN LISTS folders) # each comes after what it includes
    list(PREPEND backwards ${folder})
  endforeach()
  foreach(folder IN LISTS backwards)
    if(folder IN_LIST reached)
      list(APPEND reached ${${folder}_includes})
    endif()
  endforeach()
  list(APPEND reached ${hash_ALONE})
  list(REMOVE_DUPLICATES reached)
  foreach(folder IN LISTS reached)
    folder_hash(${folder} hash)
    list(APPEND hashes ${hash})
  endforeach()
  set(header ${CMAKE_CURRENT_BINARY_DIR}/sources/${name}.h)
  add_custom_command(
    OUTPUT ${header}
    COMMAND ${CMAKE_COMMAND} "-DFOLDER_HASHES=${hashes}" -DHEADER=${header} -DNAME=${name} -P
            ${CMAKE_CURRENT_SOURCE_DIR}/sources_hash.cmake
    DEPENDS ${hashes} sources_hash.cmake
    VERBATIM)
  target_sources(${target} PRIVATE ${header})
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
  set(generated_headers ${generated_headers} ${header} PARENT_SCOPE)
endfunction()
