# -DUPBEAD_DEALII=lean: deal.II, gmsh and PETSc of Debian's own source packages, built static and with only what is called
# here. Debian's binary packages have every option on, and bring Trilinos, OpenCASCADE, SUNDIALS, 200 libraries in all. They
# are built once, while CMake configures, in the folder UPBEAD_LEAN. For the program only: who builds upon upbead's layers
# would find the other deal.II. Without OpenCASCADE a .geo that says SetFactory("OpenCASCADE") is refused by gmsh.
set(UPBEAD_LEAN ${PROJECT_BINARY_DIR}/lean CACHE PATH "Where the lean libraries are built; builds may share it")
set(prefix ${UPBEAD_LEAN}/prefix)

# A source package, by lists of packages of our own: those of the machine stay as they are.
set(fetch [[
apt="apt-get -q -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts=$PWD/sources -o Dir::State::lists=$PWD/lists
  -o Dir::Cache=$PWD/cache -o APT::Sandbox::User=root"
if [ ! -f listed ]; then
  mkdir -p sources cache/archives/partial lists/partial
  for file in /etc/apt/sources.list.d/*.sources; do
    [ ! -f "$file" ] || sed 's/^Types:.*/Types: deb-src/' "$file" > "sources/${file##*/}"
  done
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ ! -f "$file" ] || sed -n 's/^deb /deb-src /p' "$file" > "sources/$(basename "$file" .list)-sources.list"
  done
  $apt update
  touch listed
fi
rm -rf "$1" "$1"[-_]*
$apt source "$1"
mv "$1"-*/ "$1"
]])

# upbead_lean(PACKAGE COMMANDS): fetches the source package and runs the commands of a shell in its folder, once.
function(upbead_lean package commands)
  if(EXISTS ${UPBEAD_LEAN}/made/${package})
    return()
  endif()
  message(STATUS "Building a lean ${package}: see ${UPBEAD_LEAN}/${package}.log")
  file(MAKE_DIRECTORY ${UPBEAD_LEAN}/made)
  set(log ${UPBEAD_LEAN}/${package}.log)
  execute_process(COMMAND sh -euc "${fetch}" sh ${package} WORKING_DIRECTORY ${UPBEAD_LEAN}
    OUTPUT_FILE ${log} ERROR_FILE ${log} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND sh -euc "${commands}" sh ${prefix} WORKING_DIRECTORY ${UPBEAD_LEAN}/${package}
    OUTPUT_FILE ${log} ERROR_FILE ${log} COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE_RECURSE ${UPBEAD_LEAN}/${package})
  file(TOUCH ${UPBEAD_LEAN}/made/${package})
endfunction()

# Of deal.II, in one and two dimensions, these sources. What they call besides, and nobody here, the linker throws away.
set(base auto_derivative_function bounding_box conditional_ostream data_out_base exceptions function function_time
  geometric_utilities geometry_info hdf5 incremental_function index_set logstream mpi multithread_info parallel
  parameter_handler partitioner path_search patterns polynomial polynomial_space polynomials_barycentric
  polynomials_piecewise polynomials_pyramid polynomials_wedge process_grid qprojector quadrature quadrature_lib
  scalar_polynomials_base subscriptor symmetric_tensor table_handler tensor tensor_function
  tensor_product_polynomials tensor_product_polynomials_bubbles tensor_product_polynomials_const thread_management
  timer utilities)
set(distributed shared_tria)
set(dofs block_info dof_accessor dof_accessor_get dof_accessor_set dof_faces dof_handler dof_handler_policy
  dof_objects dof_tools dof_tools_constraints number_cache)
set(fe block_mask component_mask fe fe_data fe_dgq fe_nothing fe_poly fe_pyramid_p fe_q fe_q_base fe_q_bubbles
  fe_q_dg0 fe_q_iso_q1 fe_raviart_thomas_nodal fe_simplex_p fe_system fe_tools fe_tools_interpolate fe_values
  fe_values_inst2 fe_values_inst3 fe_values_inst4 fe_values_inst5 fe_values_inst6 fe_wedge_p mapping
  mapping_cartesian mapping_fe mapping_q mapping_q1)
set(grid cell_id grid_generator grid_reordering grid_tools grid_tools_nontemplates intergrid_map manifold
  manifold_lib persistent_tria reference_cell tria tria_accessor tria_description tria_faces tria_levels
  tria_objects)
set(hp fe_collection fe_values mapping_collection)
set(lac affine_constraints block_vector dynamic_sparsity_pattern full_matrix la_parallel_block_vector
  la_parallel_vector lapack_full_matrix read_write_vector sparsity_pattern sparsity_tools vector vector_memory)
set(matrix_free evaluation_template_factory evaluation_template_factory_inst2 evaluation_template_factory_inst3
  evaluation_template_factory_inst4 evaluation_template_factory_inst5 evaluation_template_factory_inst6 shape_info)
set(multigrid mg_tools)
set(non_matching immersed_surface_quadrature)
set(numerics data_out data_out_dof_data data_out_dof_data_codim data_out_dof_data_inst2 data_postprocessor)
foreach(folder base distributed dofs fe grid hp lac matrix_free multigrid non_matching numerics)
  foreach(source ${${folder}})
    string(APPEND objects " source/${folder}/CMakeFiles/obj_${folder}_release.dir/${source}.cc.o")
  endforeach()
endforeach()
upbead_lean(deal.ii "
sed -i '/^DIMENSIONS/s/{.*}/{ 1; 2 }/' cmake/config/template-arguments.in
sed -i 's/space_dimension : DIMENSIONS/space_dimension : SPACE_DIMENSIONS/' source/grid/tria_accessor.inst.in
cmake -G Ninja -S . -B build -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF -DDEAL_II_ALLOW_AUTODETECTION=OFF \\
  -DDEAL_II_ALLOW_BUNDLED=OFF -DDEAL_II_ALLOW_PLATFORM_INTROSPECTION=OFF -DDEAL_II_HAVE_FP_EXCEPTIONS=FALSE \\
  -DDEAL_II_UNITY_BUILD=OFF -DDEAL_II_WITH_BOOST=ON -DDEAL_II_WITH_LAPACK=ON -DDEAL_II_WITH_METIS=ON \\
  -DDEAL_II_WITH_COMPLEX_VALUES=OFF '-DDEAL_II_CXX_FLAGS=-std=c++17 -ffunction-sections -fdata-sections'
cd build
ninja ${objects}
mkdir -p $1/lib $1/include
ar qc $1/lib/libdeal_II.a ${objects}
cp -r ../include/deal.II include/deal.II $1/include
")
upbead_lean(gmsh [[
cmake -G Ninja -S . -B build -DCMAKE_BUILD_TYPE=Release -DDEFAULT=OFF -DENABLE_BUILD_LIB=ON -DENABLE_SYSTEM_CONTRIB=ON \
  -DEIGEN_INC=/usr/include/eigen3 -DENABLE_GMP=OFF -DENABLE_PARSER=ON -DENABLE_MESH=ON -DENABLE_POST=ON -DENABLE_ONELAB=ON \
  -DENABLE_BLOSSOM=ON -DENABLE_BAMG=ON -DENABLE_MATHEX=ON '-DCMAKE_CXX_FLAGS=-ffunction-sections -fdata-sections'
cmake --build build --target lib
install -D -m 644 -t "$1/lib" build/libgmsh.a
install -D -m 644 -t "$1/include" api/gmsh.h
]])
upbead_lean(petsc [[
/usr/bin/python3 ./configure PETSC_ARCH=lean --prefix="$1" --with-shared-libraries=0 --with-debugging=0 --with-x=0 --with-ssl=0 \
  --with-hwloc=0 --with-fortran-bindings=0 --with-scalapack-lib=-lscalapack-openmpi --with-mumps-include=/usr/include \
  --with-mumps-lib="-ldmumps -lmumps_common -lpord" COPTFLAGS="-O2 -ffunction-sections"
make PETSC_DIR="$PWD" PETSC_ARCH=lean all
make PETSC_DIR="$PWD" PETSC_ARCH=lean install
]])

list(PREPEND CMAKE_PREFIX_PATH ${prefix})
find_package(MPI REQUIRED COMPONENTS CXX)
find_package(PkgConfig REQUIRED)
find_library(lean_hdf5 hdf5 PATH_SUFFIXES hdf5/serial REQUIRED)
find_path(lean_hdf5_headers hdf5.h PATH_SUFFIXES hdf5/serial REQUIRED)
find_library(lean_metis metis REQUIRED)
set(DEAL_II_PACKAGE_VERSION 9.4.1)
set(DEAL_II_INCLUDE_DIRS ${prefix}/include ${lean_hdf5_headers} ${MPI_CXX_INCLUDE_DIRS})
set(DEAL_II_LIBRARIES_RELEASE ${prefix}/lib/libdeal_II.a ${prefix}/lib/libgmsh.a ${lean_hdf5} ${lean_metis} lapack blas
  ${CMAKE_DL_LIBS})
list(APPEND PKG_CONFIG_ARGN --static) # what a static PETSc stands on
add_link_options(LINKER:--gc-sections)
