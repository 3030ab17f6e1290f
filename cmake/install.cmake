# cmake --install BUILD --prefix P: the program with what it reads, and the rooms that brains in
# C++ link to. `--component brain_client` installs only these rooms.

# smile_rooms_below(ROOM OUT): the room, and whom it may include, down to the ground.
function(smile_rooms_below ROOM OUT)
  get_property(rooms GLOBAL PROPERTY smile_room_${ROOM})
  set(all ${ROOM})
  foreach(room IN LISTS rooms)
    smile_rooms_below(${room} below)
    list(APPEND all ${below})
  endforeach()
  list(REMOVE_DUPLICATES all)
  set(${OUT} ${all} PARENT_SCOPE)
endfunction()

smile_rooms_below(brain_client client_rooms)
smile_rooms_below(motion motion_rooms)
set(installed_rooms ${client_rooms} ${motion_rooms})
list(REMOVE_DUPLICATES installed_rooms)
set(installed_libraries)
set(room_names)  # of rooms that a wing contains: brains go on linking to smile::ROOM
foreach(room IN LISTS installed_rooms)
  get_target_property(wing smile_${room} ALIASED_TARGET)
  if(wing)
    list(APPEND installed_libraries ${wing})
    get_target_property(name ${wing} EXPORT_NAME)
    string(APPEND room_names "add_library(smile::${room} ALIAS smile::${name})\n")
  else()
    list(APPEND installed_libraries smile_${room})
  endif()
  install(DIRECTORY src/${room} DESTINATION include/smile COMPONENT brain_client FILES_MATCHING PATTERN "*.h"
          PATTERN "internal_*" EXCLUDE PATTERN "test" EXCLUDE)
endforeach()
list(REMOVE_DUPLICATES installed_libraries)
install(TARGETS ${installed_libraries} EXPORT smile ARCHIVE DESTINATION lib COMPONENT brain_client)
file(WRITE ${CMAKE_BINARY_DIR}/smileRooms.cmake "${room_names}")
# The header that older brains include.
install(DIRECTORY cmake/earlier_names/agent DESTINATION include/smile COMPONENT brain_client)
# The library that smilelink.cc links to when `mex` compiles it.
install(TARGETS smile_brain_protocol ARCHIVE DESTINATION lib COMPONENT brain_client)
install(EXPORT smile NAMESPACE smile:: FILE smileTargets.cmake DESTINATION lib/cmake/smile
        COMPONENT brain_client)
install(FILES cmake/smileConfig.cmake ${CMAKE_BINARY_DIR}/smileRooms.cmake DESTINATION lib/cmake/smile COMPONENT brain_client)

install(TARGETS smile smile_supervisor RUNTIME DESTINATION bin)
install(DIRECTORY robots scenes examples matlab python learner DESTINATION share/smile
        PATTERN "__pycache__" EXCLUDE)
# The studio's page, where it was built.
install(DIRECTORY build/page DESTINATION share/smile/build OPTIONAL
        PATTERN ".built" EXCLUDE PATTERN "*.map" EXCLUDE)
install(FILES ${CMAKE_BINARY_DIR}/matlab/smilelink.mex
              ${CMAKE_BINARY_DIR}/matlab/smile_guard.oct
              ${CMAKE_BINARY_DIR}/matlab/smilemotion.mex
        DESTINATION share/smile/matlab/client OPTIONAL)
foreach(module smile_brain_native smile_motion_native smile_simulator_native)
  if(TARGET ${module})
    install(TARGETS ${module} LIBRARY DESTINATION share/smile/python)
  endif()
endforeach()
