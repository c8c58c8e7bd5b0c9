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

# Libraries of another recipe are made anew.
file(SHA1 ${CMAKE_CURRENT_LIST_FILE} recipe)
file(SHA1 ${CMAKE_CURRENT_LIST_DIR}/unity.py groups)
string(SHA1 recipe "${recipe}${groups}")

# upbead_lean(PACKAGE COMMANDS): fetches the source package and runs the commands of a shell in its folder, once.
function(upbead_lean package commands)
  if(EXISTS ${UPBEAD_LEAN}/made/${package}-${recipe})
    return()
  endif()
  message(STATUS "Building a lean ${package}: see ${UPBEAD_LEAN}/${package}.log")
  file(MAKE_DIRECTORY ${UPBEAD_LEAN}/made)
  set(log ${UPBEAD_LEAN}/${package}.log)
  execute_process(COMMAND sh -euc "${fetch}" sh ${package} WORKING_DIRECTORY ${UPBEAD_LEAN}
    OUTPUT_FILE ${log} ERROR_FILE ${log} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND sh -euc "${compile}${commands}" sh ${prefix} WORKING_DIRECTORY ${UPBEAD_LEAN}/${package}
    OUTPUT_FILE ${log} ERROR_FILE ${log} COMMAND_ERROR_IS_FATAL ANY)
  file(REMOVE_RECURSE ${UPBEAD_LEAN}/${package})
  file(TOUCH ${UPBEAD_LEAN}/made/${package}-${recipe})
endfunction()

# A compiler that looks for memory to free only from 1.5 GB on takes a tenth less time.
set(late_garbage --param=ggc-min-heapsize=1500000)

# Each source of a folder given to a compiler, on all cores; and of the objects a library.
set(compile [[
compile() { # FOLDER COMPILER OPTIONS ...
  folder=$1
  shift
  find "$folder" -name '*.c' -o -name '*.cc' -o -name '*.cpp' | xargs -P "$(env -u OMP_NUM_THREADS nproc)" -I {} "$@" -w @late_garbage@ -fPIC -ffunction-sections -fdata-sections -c {} -o {}.o
}
unity() { /usr/bin/python3 -B "@here@/unity.py" "$@"; }
]])
string(REPLACE @here@ ${CMAKE_CURRENT_LIST_DIR} compile "${compile}")
string(REPLACE @late_garbage@ ${late_garbage} compile "${compile}")

# Of deal.II, in one and two dimensions and in double precision alone, these sources, each folder in so many parts. What they
# call besides, and nobody here, the linker throws away.
set(base auto_derivative_function bounding_box conditional_ostream data_out_base exceptions function function_time
  geometric_utilities geometry_info hdf5 incremental_function index_set logstream mpi multithread_info parallel
  parameter_handler partitioner path_search patterns polynomial polynomial_space polynomials_barycentric
  polynomials_piecewise polynomials_pyramid polynomials_wedge process_grid qprojector quadrature quadrature_lib
  scalar_polynomials_base subscriptor symmetric_tensor table_handler tensor tensor_function
  tensor_product_polynomials tensor_product_polynomials_bubbles tensor_product_polynomials_const thread_management
  timer utilities)
set(distributed shared_tria)
set(dofs block_info dof_accessor dof_accessor_get dof_accessor_set dof_faces dof_handler dof_handler_policy
  dof_objects dof_tools number_cache)
set(constraints dof_tools_constraints)
set(fe block_mask component_mask fe fe_data fe_dgq fe_nothing fe_poly fe_pyramid_p fe_q fe_q_base fe_q_bubbles
  fe_q_dg0 fe_q_iso_q1 fe_raviart_thomas_nodal fe_simplex_p fe_system fe_tools fe_tools_interpolate fe_values fe_wedge_p
  mapping mapping_cartesian mapping_fe mapping_q mapping_q1)
set(grid cell_id grid_generator grid_reordering grid_tools grid_tools_nontemplates intergrid_map manifold
  manifold_lib persistent_tria reference_cell tria tria_accessor tria_description tria_faces tria_levels
  tria_objects)
set(hp fe_collection fe_values mapping_collection)
set(lac affine_constraints block_vector dynamic_sparsity_pattern full_matrix la_parallel_block_vector
  la_parallel_vector lapack_full_matrix read_write_vector sparsity_pattern sparsity_tools vector vector_memory)
set(matrix_free evaluation_template_factory shape_info)
set(multigrid mg_tools)
set(non_matching immersed_surface_quadrature)
set(numerics data_out data_out_dof_data data_out_dof_data_codim data_postprocessor)
# Parts of a folder, which are compiled as one each; where none are given, one.
set(parts_base 2)
set(parts_fe 3)
set(parts_grid 2)
file(REMOVE_RECURSE ${UPBEAD_LEAN}/parts)
foreach(folder base distributed dofs constraints fe grid hp lac matrix_free multigrid non_matching numerics)
  set(place ${folder})
  if(folder STREQUAL "constraints")
    set(place dofs)
  endif()
  set(n 0)
  foreach(source ${${folder}})
    set(part ${folder}_0)
    if(DEFINED parts_${folder})
      math(EXPR k "${n} % ${parts_${folder}}")
      set(part ${folder}_${k})
    endif()
    string(APPEND text_${part} "#include \"${place}/${source}.cc\"\n")
    file(WRITE ${UPBEAD_LEAN}/parts/${part}.cc "${text_${part}}")
    math(EXPR n "${n} + 1")
  endforeach()
endforeach()
upbead_lean(deal.ii [[
sed -i '/^DIMENSIONS/s/{.*}/{ 1; 2 }/; /^REAL_SCALARS  /s/double; float/double/; /^[^_]*<float>/d; /^ *float;$/d; /LinearAlgebra::/d
  s/@DEAL_II_EXPAND_FLOAT_VECTORIZED@;//
  /^VECTOR_TYPES/,/}/s/ BlockVector<double>;/ LinearAlgebra::distributed::BlockVector<double>;/' cmake/config/template-arguments.in
sed -i 's/space_dimension : DIMENSIONS/space_dimension : SPACE_DIMENSIONS/' source/grid/tria_accessor.inst.in
grep -rlZ 'define SPLIT_INSTANTIATIONS_COUNT' source | xargs -0 sed -i 's/\(define SPLIT_INSTANTIATIONS_COUNT\) .*/\1 1/'
cmake -G Ninja -S . -B build -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=OFF -DDEAL_II_ALLOW_AUTODETECTION=OFF \
  -DDEAL_II_ALLOW_BUNDLED=OFF -DDEAL_II_ALLOW_PLATFORM_INTROSPECTION=OFF -DDEAL_II_HAVE_FP_EXCEPTIONS=FALSE \
  -DDEAL_II_UNITY_BUILD=OFF -DDEAL_II_WITH_BOOST=ON -DDEAL_II_WITH_LAPACK=ON -DDEAL_II_WITH_METIS=ON \
  -DDEAL_II_WITH_COMPLEX_VALUES=OFF
ninja -C build expand_all_instantiations
cp -r build/source .
compile ../parts c++ -std=c++17 -O2 -DNDEBUG -DBOOST_NO_AUTO_PTR -DFE_EVAL_FACTORY_DEGREE_MAX=2 -Isource -Iinclude -Ibuild/include
mkdir -p "$1/lib" "$1/include"
rm -f "$1/lib/libdeal_II.a"
ar qc "$1/lib/libdeal_II.a" ../parts/*.o
cp -r include/deal.II build/include/deal.II "$1/include"
]])

# Of gmsh what reads scripts and meshes, and meshes.
upbead_lean(gmsh [[
cmake -G Ninja -S . -B build -DCMAKE_BUILD_TYPE=Release -DDEFAULT=OFF -DENABLE_BUILD_LIB=ON -DENABLE_SYSTEM_CONTRIB=ON \
  -DEIGEN_INC=/usr/include/eigen3 -DENABLE_GMP=OFF -DENABLE_PARSER=ON -DENABLE_MESH=ON -DENABLE_POST=ON -DENABLE_ONELAB=ON \
  -DENABLE_BLOSSOM=ON -DENABLE_BAMG=ON -DENABLE_MATHEX=ON '-DCMAKE_CXX_FLAGS=-ffunction-sections -fdata-sections -w' \
  '-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG'
alone="Numeric/robustPredicates|Mesh/BDS|Mesh/Background|Parser/Gmsh|contrib/b" # gmsh has them compiled with other options
alone="$alone|meshGFaceBamg|meshGRegionBoundaryRecovery|gmshLevelset"           # their headers go with no others
ninja -C build -t commands lib | sed -n "s:.* -c $PWD/::p" | grep -v api/ > sources
{ echo Numeric/fullMatrix.cpp; grep -vE "Numeric/fullMatrix|$alone" sources; } | unity . 24 parts # its specialisations come before their use
compile parts c++ -std=gnu++11 -O1 -DNDEBUG $(ninja -C build -t commands lib | head -1 | grep -o -e '-I[^ ]*')
objects=$(grep -E "$alone" sources | sed 's:.*:CMakeFiles/lib.dir/&.o:')
ninja -C build $objects
mkdir -p "$1/lib" "$1/include"
rm -f "$1/lib/libgmsh.a"
ar qc "$1/lib/libgmsh.a" parts/*.o
(cd build && ar qc "$1/lib/libgmsh.a" $objects)
cp api/gmsh.h "$1/include"
]])

# Of PETSc vectors, matrices that MUMPS takes, and Newton's and Anderson's methods, with what these call. What is left out
# answers by PETSc's error of what it does not support (56), and where PETSc starts its parts, by none. MUMPS brings ScaLAPACK
# itself, and no Fortran is compiled.
upbead_lean(petsc [[
sed -i "s/\[self.scalapack,self.mpi,self.blasLapack,self.flibs\]/[self.mpi,self.blasLapack]/; s/\['C','FC'\]/['C']/" \
  config/BuildSystem/config/packages/MUMPS.py
/usr/bin/python3 ./configure PETSC_ARCH=lean --prefix="$1" --with-shared-libraries=0 --with-debugging=0 --with-x=0 --with-ssl=0 \
  --with-hwloc=0 --with-fc=0 --with-cxx=0 --with-mumps-include=/usr/include --with-mumps-lib="-ldmumps -lmumps_common -lpord"
PETSC_DIR="$PWD" PETSC_ARCH=lean /usr/bin/python3 config/gmakegen.py --petsc-arch=lean
sed -i '1i #pragma once' src/mat/impls/sell/mpi/mpisell.h # its own guard ends before its text
wanted="(sys|vec)/|mat/(interface|utils|order|partition|coarsen|color/interface|matfd)/[^/]*$|mat/impls/(is|shell|mffd|dummy)/"
wanted="$wanted|mat/impls/(aij|baij|sbaij|dense)/(seq|mpi)/[^/]*$|mat/.*/mumps/|dm/(interface|label|impls/shell|dt/interface|field/interface)/"
wanted="$wanted|dm/dt/(fe|fv|space|dualspace)/interface/|dm/partitioner/interface/|ksp/(ksp|pc)/interface/|ksp/ksp/impls/(gmres|preonly)/[^/]*$"
wanted="$wanted|ksp/pc/impls/(none|factor|shell|factor/lu|factor/cholesky)/[^/]*$|snes/(interface|mf|utils)/[^/]*$|snes/impls/(ls|ngmres)/"
wanted="$wanted|snes/linesearch/"
unwanted="draw/impls/(image|tikz)|viewer/impls/(vtk|vu)|/pf/|/ao/|tagger|totalview|sys/python|window"
sed -n 's/^srcs-.*\.c := //p' lean/lib/petsc/conf/files | tr ' ' '\n' | grep -E "^src/($wanted)" | grep -vE "$unwanted" | unity . 40 parts
options="-O1 -D_GNU_SOURCE -Ilean/include -Iinclude $(mpicc --showme:compile)"
compile parts cc $options
mkdir -p absent "$1/lib/pkgconfig" "$1/include"
nm parts/*.o | awk 'NF == 3 && $2 != "U" {print $3}' | sort -u > there
nm parts/*.o | awk '$1 == "U" {print $2}' | sort -u | comm -23 - there |
  grep -E '^(AO|Characteristic|DM|IS|KSP|Mat|PC|PETSC|Petsc|PF|SNES|TS|Tao|Vec)' | awk '
    /_CLASSID$|^[A-Z]+_|^DMNetwork_|Citation|cite$|List$/ { print "long " $1 "[64];"; next } # data, such as numbers of events
    { print "int " $1 "(void) { return " (/Initialize|Register|Server/ ? 0 : 56) "; }" }' > absent/absent.c
compile absent cc
rm -f "$1/lib/libpetsc.a"
ar qc "$1/lib/libpetsc.a" parts/*.o absent/*.o
cp -r include/* lean/include/*.h "$1/include"
printf '#define PETSC_FUNCTION_NAME_CXX __func__\n#define PETSC_CXX_RESTRICT __restrict__\n' >> "$1/include/petscconf.h"
cp lean/lib/pkgconfig/* "$1/lib/pkgconfig"
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
add_compile_options($<$<CXX_COMPILER_ID:GNU>:${late_garbage}>)
add_link_options(LINKER:--gc-sections)
