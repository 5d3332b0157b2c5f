# A world file gives the same bytes by the program and by the library. WORLDS, PROGRAM, EXAMPLE, FOLDER.
foreach(world ${WORLDS})
  get_filename_component(name ${world} NAME_WE)
  execute_process(COMMAND ${PROGRAM} render ${world} -o ${FOLDER}/program-${name}.png --quiet RESULT_VARIABLE by_program)
  execute_process(COMMAND ${EXAMPLE} ${world} ${FOLDER}/library-${name}.png RESULT_VARIABLE by_library OUTPUT_QUIET)
  if(NOT by_program EQUAL 0 OR NOT by_library EQUAL 0)
    message(FATAL_ERROR "${world}: program ${by_program}, library ${by_library}")
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${FOLDER}/program-${name}.png ${FOLDER}/library-${name}.png
    RESULT_VARIABLE differs)
  if(differs)
    message(FATAL_ERROR "${world}: the pictures of program and library differ")
  endif()
endforeach()
