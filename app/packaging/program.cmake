# Install rules of the program: binary, samples, desktop entry and icon. The program finds its samples relative to
# itself, so the installed tree can be moved.
install(TARGETS forefront RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(TARGET forefront_ui)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/samples ${PROJECT_SOURCE_DIR}/assets/lessons
          ${PROJECT_SOURCE_DIR}/assets/exercise
          DESTINATION ${CMAKE_INSTALL_DATADIR}/forefront/assets)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/forefront.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/forefront.svg
          DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
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
