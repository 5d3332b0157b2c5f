# Run by CPack over the folders of all components before they become packages: what Debian's policy wants in each.
# SOURCE_DATE_EPOCH of the environment is the time of every file, so that a second build gives the same bytes.
set(epoch $ENV{SOURCE_DATE_EPOCH})
if(NOT epoch)
  message(FATAL_ERROR "SOURCE_DATE_EPOCH is not set; tools/package/make_packages.sh sets it")
endif()

macro(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endmacro()

# zip(FILE): FILE becomes FILE.gz.
function(zip file)
  run(gzip -9nf ${file})
endfunction()

function(finish component)
  string(TOUPPER ${component} upper)
  set(package ${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(tree ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component})
  set(folder ${tree}/usr/share)
  set(doc ${folder}/doc/${package})
  file(COPY ${CPACK_RAKELIGHT_DEBIAN}/copyright DESTINATION ${doc})
  file(COPY_FILE ${CPACK_RAKELIGHT_CHANGELOG} ${doc}/changelog)
  run(date -u -R -d @${epoch} OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE)
  file(WRITE ${doc}/changelog.Debian "rakelight (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) bookworm; urgency=medium\n\n"
    "  * Initial release of ${CPACK_PACKAGE_VERSION}; what is new in it is in changelog.gz.\n\n -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  zip(${doc}/changelog)
  zip(${doc}/changelog.Debian)
  file(REMOVE ${doc}/LICENSE ${folder}/doc/rakelight/LICENSE)  # copyright has it
  file(GLOB manuals ${folder}/man/man*/*.[0-9])
  foreach(manual IN LISTS manuals)
    zip(${manual})
  endforeach()
  # What no program reads; archives keep their names' tables.
  file(GLOB binaries ${tree}/usr/bin/* ${tree}/usr/libexec/rakelight/*
    ${tree}/usr/lib/*/*.so.*.* ${tree}/usr/lib/*/*.a ${tree}/usr/lib/python3/dist-packages/rakelight/*.so)
  foreach(binary IN LISTS binaries)
    run(${CPACK_RAKELIGHT_STRIP} --enable-deterministic-archives --strip-debug --remove-section=.comment --remove-section=.note ${binary})
  endforeach()
  file(STRINGS ${CPACK_RAKELIGHT_DEBIAN}/lintian-overrides overrides REGEX "^(#|${package}: )")
  list(JOIN overrides "\n" overrides)
  file(WRITE ${folder}/lintian/overrides/${package} "${overrides}\n")
  run(find ${tree} -exec touch --no-dereference --date=@${epoch} {} +)
endfunction()

foreach(component IN LISTS CPACK_COMPONENTS_ALL)
  finish(${component})
endforeach()
