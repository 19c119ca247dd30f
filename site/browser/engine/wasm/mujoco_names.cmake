# MuJoCo's C interface by name, for program_api.c: mujoco_names(HEADER FOLDER) reads mujoco.h and
# writes mujoco_functions.inc and mujoco_variables.inc into the folder. The renderer (mjr_, mjui_) is
# not in the engine.
function(mujoco_names header folder)
  file(READ ${header} text)

  string(REGEX MATCHALL "MJAPI [^(;=]+\\(" functions "${text}")
  list(FILTER functions INCLUDE REGEX "[ *]mj[A-Za-z0-9_]+\\($")
  list(FILTER functions EXCLUDE REGEX "[ *]mj(r|ui)_")
  list(TRANSFORM functions REPLACE "^.*[ *](mj[A-Za-z0-9_]+)\\($" "FUNCTION(\\1)")
  list(JOIN functions "\n" functions)
  file(CONFIGURE OUTPUT ${folder}/mujoco_functions.inc CONTENT "${functions}\n" @ONLY)

  string(REGEX MATCHALL "MJAPI extern [^;]+" variables "${text}")
  list(TRANSFORM variables REPLACE "^.*[ *](mj[A-Za-z0-9_]+)(\\[.*|\\)\\(.*|)$" "VARIABLE(\\1)")
  list(JOIN variables "\n" variables)
  file(CONFIGURE OUTPUT ${folder}/mujoco_variables.inc CONTENT "${variables}\n" @ONLY)
endfunction()
