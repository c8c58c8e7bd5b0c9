# Targets of libraries that bring none of their own. Part of the installation too: find_package(upbead) makes them anew
# on the machine where it looks.

# upbead_dealii(BUILD_TYPE): the target upbead::dealii. Another program must link the variant that the layers were built
# with, whatever it is built as itself. deal.II, PETSc, gmsh, HDF5 and MPI come as one package with one set of include
# folders; as system headers, so that their warnings are not ours.
function(upbead_dealii build_type)
  if(TARGET upbead::dealii)
    return()
  endif()
  add_library(upbead::dealii INTERFACE IMPORTED)
  target_include_directories(upbead::dealii SYSTEM INTERFACE ${DEAL_II_INCLUDE_DIRS})
  target_link_options(upbead::dealii INTERFACE LINKER:--as-needed)
  if(build_type STREQUAL "Debug")
    target_link_libraries(upbead::dealii INTERFACE ${DEAL_II_LIBRARIES_DEBUG})
    target_compile_definitions(upbead::dealii INTERFACE DEBUG)
  else()
    target_link_libraries(upbead::dealii INTERFACE ${DEAL_II_LIBRARIES_RELEASE})
  endif()
endfunction()

# upbead_cholmod(): the target upbead::cholmod, without its headers, which only the layer algebra includes.
function(upbead_cholmod)
  if(TARGET upbead::cholmod)
    return()
  endif()
  find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
  add_library(upbead::cholmod UNKNOWN IMPORTED)
  set_target_properties(upbead::cholmod PROPERTIES IMPORTED_LOCATION ${CHOLMOD_LIBRARY})
endfunction()
