# Writes HEADER, in which the constant NAME is what the file TEXT holds.
file(READ ${TEXT} text)
file(
  WRITE ${HEADER}
  "#pragma once\n#include <string_view>\n"
  "inline constexpr std::string_view ${NAME} = R\"embedded(${text})embedded\";\n")
