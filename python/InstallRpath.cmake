# rl_python_rpath(OUT FOLDER): the way from the package in FOLDER, absolute or below the prefix, to the installed shared library.
function(rl_python_rpath out folder)
  cmake_path(ABSOLUTE_PATH folder BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX} NORMALIZE)
  file(RELATIVE_PATH way ${folder}/rakelight ${CMAKE_INSTALL_FULL_LIBDIR})
  set(${out} "$ORIGIN/${way}" PARENT_SCOPE)
endfunction()
