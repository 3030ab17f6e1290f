# find_package(smile): smile::brain_client, for brains in C++, and smile::motion, for planning.
find_package(PkgConfig REQUIRED)
pkg_check_modules(EIGEN REQUIRED QUIET IMPORTED_TARGET eigen3)
pkg_check_modules(JSON REQUIRED QUIET IMPORTED_TARGET nlohmann_json)
pkg_check_modules(PNG REQUIRED QUIET IMPORTED_TARGET libpng)
# Only smile::motion needs these.
pkg_check_modules(ASSIMP QUIET IMPORTED_TARGET assimp)
pkg_check_modules(LIBXML QUIET IMPORTED_TARGET libxml-2.0)
pkg_check_modules(BULLET QUIET IMPORTED_TARGET bullet-float64)
pkg_check_modules(URDF QUIET IMPORTED_TARGET urdfdom)
include("${CMAKE_CURRENT_LIST_DIR}/smileTargets.cmake")
include("${CMAKE_CURRENT_LIST_DIR}/smileRooms.cmake")
# The earlier name.
if(NOT TARGET smile::agent)
  add_library(smile::agent ALIAS smile::brain_client)
endif()
