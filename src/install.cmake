# cmake --install BUILD --prefix PREFIX. The folders have fixed names, since the program looks for ../share/upbead/meshes
# beside itself and the scripts for ../docs and ../meshes; any prefix will do, and the whole may be moved later.
include(CMakePackageConfigHelpers)

# some of PETSc's, MPI's and HDF5's libraries lie in folders of their own
set_target_properties(upbead upbead-solver upbead-reliability PROPERTIES INSTALL_RPATH_USE_LINK_PATH ON)
install(TARGETS upbead upbead-solver upbead-reliability RUNTIME DESTINATION bin COMPONENT program)

# for programs of others
get_property(layers GLOBAL PROPERTY UPBEAD_LAYERS)
list(REMOVE_ITEM layers upbead_reliability_methods upbead_cli_reliability)  # else they would have to find OpenTURNS
set(package lib/cmake/upbead)
set_target_properties(upbead_options PROPERTIES EXPORT_NAME options)
install(TARGETS upbead_options ${layers} EXPORT upbeadTargets
  ARCHIVE DESTINATION lib INCLUDES DESTINATION include)
install(EXPORT upbeadTargets NAMESPACE upbead:: DESTINATION ${package})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/upbead DESTINATION include FILES_MATCHING PATTERN *.h)
set(upbead_share share/upbead)
configure_package_config_file(upbeadConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/upbeadConfig.cmake
  INSTALL_DESTINATION ${package} PATH_VARS upbead_share)
# of versions 0.x each second number may break what the one before had
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/upbeadConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/upbeadConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/upbeadConfigVersion.cmake
  foreign_targets.cmake DESTINATION ${package})

# meshes, cases, scripts and pages stand to each other as in the source tree, so that links between them hold
foreach(folder meshes cases postprocess docs)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder} DESTINATION ${upbead_share} COMPONENT program USE_SOURCE_PERMISSIONS
    PATTERN __pycache__ EXCLUDE PATTERN *.egg-info EXCLUDE)
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGELOG.md DESTINATION ${upbead_share} COMPONENT program)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/CITATION.cff ${PROJECT_SOURCE_DIR}/CHANGELOG.md
  DESTINATION share/doc/upbead)
