# Before CPack packs what is installed in CPACK_TEMPORARY_DIRECTORY.

set(share "${CPACK_TEMPORARY_DIRECTORY}/*${CPACK_PACKAGING_INSTALL_PREFIX}/share")
file(GLOB texts "${share}/man/man1/*.1" "${share}/doc/*/changelog")
execute_process(COMMAND gzip -9 --no-name ${texts} COMMAND_ERROR_IS_FATAL ANY)
