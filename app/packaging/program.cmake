# Install rules of the program: binary, the editor's program that it starts, samples, desktop entry, project type and icons.
# The program finds its editor and samples relative to itself, so the installed tree can be moved.
install(TARGETS forefront RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
if(TARGET forefront_editor)
  install(TARGETS forefront_editor RUNTIME DESTINATION ${FOREFRONT_EDITOR_FOLDER} COMPONENT program)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/samples ${PROJECT_SOURCE_DIR}/assets/lessons
          ${PROJECT_SOURCE_DIR}/assets/exercise
          DESTINATION ${CMAKE_INSTALL_DATADIR}/forefront/assets COMPONENT program)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/forefront.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications
          COMPONENT program)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/forefront.metainfo.xml
          DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo RENAME invalid.forefront.forefront.metainfo.xml
          COMPONENT program)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/forefront-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
          RENAME forefront.xml COMPONENT program)
  set(icons ${CMAKE_INSTALL_DATADIR}/icons/hicolor)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/forefront.svg DESTINATION ${icons}/scalable/apps COMPONENT program)
  # Desktops without a reader of SVG, and catalogues of programs, take pictures of fixed sizes.
  find_program(RSVG_CONVERT rsvg-convert)
  if(RSVG_CONVERT)
    set(pictures "")
    foreach(size IN ITEMS 48 64 128 256)
      set(picture ${CMAKE_CURRENT_BINARY_DIR}/icons/${size}/forefront.png)
      add_custom_command(
        OUTPUT ${picture}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_CURRENT_BINARY_DIR}/icons/${size}
        COMMAND ${RSVG_CONVERT} -w ${size} -h ${size} -o ${picture} ${CMAKE_CURRENT_LIST_DIR}/forefront.svg
        DEPENDS ${CMAKE_CURRENT_LIST_DIR}/forefront.svg
        COMMENT "" VERBATIM)
      list(APPEND pictures ${picture})
      install(FILES ${picture} DESTINATION ${icons}/${size}x${size}/apps COMPONENT program)
    endforeach()
    add_custom_target(forefront_icons ALL DEPENDS ${pictures})
  endif()
endif()

# The manual page and the completions are printed by the program itself.
set(written ${CMAKE_CURRENT_BINARY_DIR}/share)
file(MAKE_DIRECTORY ${written})
add_custom_command(
  TARGET forefront POST_BUILD
  COMMAND forefront help --man > ${written}/forefront.1
  COMMAND forefront completion bash > ${written}/forefront
  COMMAND forefront completion zsh > ${written}/_forefront
  COMMAND forefront completion fish > ${written}/forefront.fish
  BYPRODUCTS ${written}/forefront.1 ${written}/forefront ${written}/_forefront ${written}/forefront.fish)
install(FILES ${written}/forefront.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${written}/forefront DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${written}/_forefront DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${written}/forefront.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
