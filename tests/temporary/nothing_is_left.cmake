# ctest runs this after the last test; an error here is one of ctest.
file(GLOB left RELATIVE ${FOLDER} ${FOLDER}/* ${FOLDER}/.*)
file(REMOVE_RECURSE ${FOLDER})
if(left)
  list(JOIN left " " names)
  message(FATAL_ERROR "tests left temporary files behind: ${names}")
endif()
