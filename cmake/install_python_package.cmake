# What a wheel contains beside python/smile: in the folder of the package, the compiled modules, and the
# program with what it reads in the layout of cmake/install.cmake.
install(TARGETS smile_brain_native smile_motion_native smile_simulator_native
        LIBRARY DESTINATION . COMPONENT python_package)
install(TARGETS smile smile_supervisor RUNTIME DESTINATION bin COMPONENT python_package)
install(DIRECTORY robots scenes examples matlab learner DESTINATION share/smile COMPONENT python_package
        PATTERN "__pycache__" EXCLUDE PATTERN "test" EXCLUDE)
install(DIRECTORY python/learner python/examples DESTINATION share/smile/python COMPONENT python_package
        PATTERN "__pycache__" EXCLUDE)
# The studio's page, where it was built.
install(DIRECTORY build/page DESTINATION share/smile/build COMPONENT python_package OPTIONAL
        PATTERN ".built" EXCLUDE PATTERN "*.map" EXCLUDE)
