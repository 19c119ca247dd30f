# Writes HEADER with a hash of all SOURCES, and leaves it alone where it has that already.
set(hashes "")
foreach(source IN LISTS SOURCES)
  file(SHA256 ${source} hash)
  string(APPEND hashes "${source} ${hash}\n")
endforeach()
string(SHA256 all "${hashes}")
string(SUBSTRING ${all} 0 16 all)
file(CONFIGURE OUTPUT ${HEADER} CONTENT "#pragma once\n#define MJCOURSE_SOURCES \"${all}\"\n" @ONLY)
