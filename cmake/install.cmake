# What `cmake --install` puts in place: headers, libraries, the tool with its manual and completions,
# and the package that find_package(planetree) finds. The whole may be moved afterwards.
include(CMakePackageConfigHelpers)

set(planetree_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/planetree)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Installs a library with an export file of its own, and sets `packages` to the packages that must be
# found before it can be linked to. A static library passes on all that it links to itself, a shared
# one nothing; an imported target is named after its package (TBB::tbb).
function(planetree_install_library library packages)
  set_target_properties(${library} PROPERTIES INSTALL_RPATH "$ORIGIN")
  install(TARGETS ${library} EXPORT ${library}_targets)
  install(EXPORT ${library}_targets NAMESPACE planetree:: DESTINATION ${planetree_package_dir})

  set(found)
  get_target_property(type ${library} TYPE)
  if(type STREQUAL "STATIC_LIBRARY")
    get_target_property(links ${library} LINK_LIBRARIES)
    foreach(link IN LISTS links)
      if(link MATCHES "^([A-Za-z0-9_]+)::" AND NOT CMAKE_MATCH_1 STREQUAL "planetree")
        list(APPEND found ${CMAKE_MATCH_1})
      endif()
    endforeach()
    list(REMOVE_DUPLICATES found)
  endif()
  set(${packages} "${found}" PARENT_SCOPE)
endfunction()

planetree_install_library(planetree planetree_core_packages)
if(TARGET planetree_io)
  planetree_install_library(planetree_io planetree_io_packages)
endif()
if(TARGET planetree_tool)
  file(RELATIVE_PATH libraries_from_bin /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
  set_target_properties(planetree_tool PROPERTIES INSTALL_RPATH "$ORIGIN/${libraries_from_bin}")
  install(TARGETS planetree_tool)
  get_target_property(reference planetree_tool PLANETREE_REFERENCE_DIR)
  install(FILES ${reference}/planetree.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${reference}/planetree.bash RENAME planetree
          DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${reference}/_planetree
          DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/site-functions)
  install(FILES ${reference}/planetree.fish
          DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
  install(TARGETS planetree_assimp DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/planetree)
endif()

configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/planetreeConfig.cmake.in
  ${PROJECT_BINARY_DIR}/planetreeConfig.cmake INSTALL_DESTINATION ${planetree_package_dir})
# Before 1.0 a new minor version may break the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/planetreeConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/planetreeConfig.cmake
              ${PROJECT_BINARY_DIR}/planetreeConfigVersion.cmake
        DESTINATION ${planetree_package_dir})
