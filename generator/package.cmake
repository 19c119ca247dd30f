# Installing: `cmake --install build/release --prefix DIR` gives bin/mjcourse and share/mjcourse, which
# work from wherever they are moved to together (cli/verify.h: assets_folder); `cpack -G DEB` in the
# build tree makes a Debian package of them. Both take what was built (the target
# mjcourse_with_assets), and build nothing.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
install(TARGETS mjcourse DESTINATION bin)
# One of the assets is a program: the Node that runs others as a page does.
install(DIRECTORY ${CMAKE_BINARY_DIR}/assets/ DESTINATION share/mjcourse USE_SOURCE_PERMISSIONS)
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION share/doc/mjcourse RENAME copyright)
install(FILES ${CMAKE_SOURCE_DIR}/CHANGELOG.md DESTINATION share/doc/mjcourse)

set(CPACK_PACKAGE_CONTACT "mjcourse maintainers <root@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "course sites from lessons that are run and proved")
set(CPACK_PACKAGE_DESCRIPTION
    "Turns lessons in Markdown into a static site: compiles and runs their C++ programs against
MuJoCo, rehearses their labs, proves the answers of their questions, and fails where a lesson
says something that is not so. `mjcourse init DIR` begins a course.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
# Libraries are found by dpkg-shlibdeps, but for those that are loaded late (base/late_library.h). Beside
# them, what is run, and what lessons' programs include: the compilers in the order in which they are
# looked for.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "libjavascriptcoregtk-4.1-0, libosmesa6, clang-16 | clang-19 | clang-14 | clang | g++, binutils, \
libmujoco-dev, libeigen3-dev, ffmpeg")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "clang-16, mold, git, clang-22")
include(CPack)
