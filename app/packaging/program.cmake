# Install rules of the program: binary, samples, desktop entry and icon. The program finds its samples relative to
# itself, so the installed tree can be moved.
install(TARGETS forefront RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(TARGET forefront_editor)
  install(TARGETS forefront_editor RUNTIME DESTINATION ${FOREFRONT_EDITOR_FOLDER})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/samples ${PROJECT_SOURCE_DIR}/assets/lessons
          ${PROJECT_SOURCE_DIR}/assets/exercise
          DESTINATION ${CMAKE_INSTALL_DATADIR}/forefront/assets)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/forefront.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/forefront.svg
          DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()
