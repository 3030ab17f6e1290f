# smile_wing(NAME room...)
#
# With SMILE_WINGS, the rooms of a wing are one library and one compilation: the headers that they
# share are read, and the templates instantiated, once. That makes the first build of a program
# faster, and the next one after a change slower; it hides which room includes what. The options of
# the first room are those of the wing.
function(smile_wing NAME)
  set_property(GLOBAL PROPERTY smile_wing_${NAME} ${ARGN})
  foreach(room IN LISTS ARGN)
    set_property(GLOBAL PROPERTY smile_wing_of_${room} ${NAME})
  endforeach()
endfunction()

# smile_room(NAME [MAY_INCLUDE room...] [TESTS_MAY_INCLUDE room...] [PUBLIC lib...] [PRIVATE lib...]
#            [DEFINES macro=value...] [NEEDS program...])
#
# One folder under src/ = one room = one target smile::NAME. Its sources are src/NAME/*.cc, its tests
# src/NAME/test/*_test.cc. MAY_INCLUDE is the include table of docs/architecture.md; a test reads this
# file's calls and compares them with the #include lines it finds. TESTS_MAY_INCLUDE lists further rooms
# that only the unit tests include. Third-party libraries have one home:
# PRIVATE keeps their headers there, PUBLIC is for the two that everybody speaks (Eigen, JSON).
# NEEDS lists programs of ours that the room starts.
function(smile_room NAME)
  cmake_parse_arguments(ROOM "" "" "MAY_INCLUDE;TESTS_MAY_INCLUDE;PUBLIC;PRIVATE;DEFINES;NEEDS" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${NAME}/*.cc)
  set_property(GLOBAL PROPERTY smile_room_${NAME} ${ROOM_MAY_INCLUDE})
  list(TRANSFORM ROOM_MAY_INCLUDE PREPEND smile_)
  list(TRANSFORM ROOM_TESTS_MAY_INCLUDE PREPEND smile_)

  get_property(wing GLOBAL PROPERTY smile_wing_of_${NAME})
  if(SMILE_WINGS AND wing)
    set(library smile_${wing}_wing)
    get_property(neighbors GLOBAL PROPERTY smile_wing_${wing})
    list(TRANSFORM neighbors PREPEND smile_)
    list(REMOVE_ITEM ROOM_MAY_INCLUDE ${neighbors})
  else()
    set(library smile_${NAME})
  endif()
  if(NOT TARGET ${library})
    add_library(${library} STATIC)
    string(REPLACE "smile_" "" export_name ${library})
    set_target_properties(${library} PROPERTIES LINKER_LANGUAGE CXX EXPORT_NAME ${export_name})
    target_compile_features(${library} PUBLIC cxx_std_20)
    target_include_directories(${library} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
                                                 $<INSTALL_INTERFACE:include/smile>)
    smile_warnings(${library})
    if(NOT NAME IN_LIST smile_rooms_that_compute)
      target_compile_options(${library} PRIVATE ${SMILE_ROOM_OPTIMIZATION})
    endif()
    if(NOT NAME IN_LIST smile_rooms_that_fuzzers_know)
      smile_unknown_to_fuzzers(${library})
    endif()
  endif()
  if(NOT library STREQUAL smile_${NAME})
    add_library(smile_${NAME} ALIAS ${library})
  endif()
  add_library(smile::${NAME} ALIAS ${library})
  target_sources(${library} PRIVATE ${sources})
  target_link_libraries(${library} PUBLIC ${ROOM_MAY_INCLUDE} ${ROOM_PUBLIC}
                                   PRIVATE ${ROOM_PRIVATE})
  target_compile_definitions(${library} PRIVATE ${ROOM_DEFINES})
  if(ROOM_NEEDS)
    add_dependencies(${library} ${ROOM_NEEDS})
  endif()

  file(GLOB test_sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${NAME}/test/*_test.cc)
  if(SMILE_SANITIZE AND NOT NAME IN_LIST smile_rooms_whose_tests_are_sanitized)
    set(test_sources)
  endif()
  if(SMILE_TESTS AND test_sources)
    add_executable(smile_${NAME}_test ${test_sources})
    target_link_libraries(smile_${NAME}_test PRIVATE smile_${NAME} ${ROOM_TESTS_MAY_INCLUDE}
                          ${ROOM_PRIVATE} GTest::gtest_main)
    target_include_directories(smile_${NAME}_test PRIVATE
                               ${CMAKE_CURRENT_SOURCE_DIR}/${NAME}/test)
    target_compile_definitions(smile_${NAME}_test PRIVATE
                               SMILE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    smile_warnings(smile_${NAME}_test)
    if(NAME IN_LIST smile_rooms_whose_tests_compute)
      smile_lightly_sanitized(smile_${NAME}_test)
    else()
      smile_quickly_compiled(smile_${NAME}_test)
    endif()
    # One compilation for all tests of a room: most of its time goes into what they all include.
    set_target_properties(smile_${NAME}_test PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
    gtest_discover_tests(smile_${NAME}_test TEST_PREFIX ${NAME}. DISCOVERY_MODE PRE_TEST
                         PROPERTIES TIMEOUT 300)
  endif()
endfunction()

# Most tests wait longer for the compiler than they run: what they do themselves is optimised as
# SMILE_TEST_OPTIMIZATION says. Of an inline function that a test and a room both have, the linker
# takes the copy of the test: tests that compute much are optimised like the rooms.
function(smile_quickly_compiled TARGET)
  target_compile_options(${TARGET} PRIVATE ${SMILE_TEST_OPTIMIZATION})
  smile_lightly_sanitized(${TARGET})
endfunction()

# What tests do themselves is sanitized for addresses only: the rest would be a third of their
# compilation.
function(smile_lightly_sanitized TARGET)
  if(SMILE_SANITIZE MATCHES "undefined")
    target_compile_options(${TARGET} PRIVATE -fno-sanitize=undefined)
  endif()
  smile_unknown_to_fuzzers(${TARGET})
endfunction()

# The edges that a fuzzer counts are those of the rooms that read: counting takes time everywhere.
function(smile_unknown_to_fuzzers TARGET)
  if(SMILE_SANITIZE MATCHES "fuzzer-no-link")
    target_compile_options(${TARGET} PRIVATE -fno-sanitize=fuzzer-no-link)
  endif()
endfunction()

# For what Python or Octave load: they do not run under a sanitizer.
function(smile_not_sanitized TARGET)
  if(SMILE_SANITIZE)
    target_compile_options(${TARGET} PRIVATE -fno-sanitize=all)
    target_link_options(${TARGET} PRIVATE -fno-sanitize=all)
  endif()
endfunction()

function(smile_warnings TARGET)
  # Every field of our structs has a default, so naming only some of them is what we want.
  target_compile_options(${TARGET} PRIVATE -Wall -Wextra -Wshadow -Wnon-virtual-dtor
                         -Wno-missing-field-initializers
                         $<$<CXX_COMPILER_ID:Clang>:-Wreserved-identifier>
                         $<$<BOOL:${SMILE_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()
