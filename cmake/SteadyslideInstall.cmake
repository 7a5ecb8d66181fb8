# Install rules, and the package for find_package(steadyslide): targets steadyslide::steadyslide, the facade,
# steadyslide::model, steadyslide::symbolic, steadyslide::statements, steadyslide::numeric, steadyslide::enclosure,
# steadyslide::proofs_checks; headers with the paths of the sources ("model/rational.hpp"). A project that uses
# steadyslide by add_subdirectory installs itself, not us.

option(STEADYSLIDE_INSTALL "Make the install rules" ${PROJECT_IS_TOP_LEVEL})
if(NOT STEADYSLIDE_INSTALL)
  return()
endif()

# Components are those of the packages (SteadyslidePackages.cmake). The default component is `development`.
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME development)
# `cmake --install` and cpack install the targets that are built.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

# Manual pages and completions, which the program itself writes; problem files, scripts and reference problems.
function(steadyslide_install_manual)
  set(folder "${PROJECT_BINARY_DIR}/manual")
  find_program(STEADYSLIDE_GZIP gzip REQUIRED)
  configure_file("${PROJECT_SOURCE_DIR}/checker/steadyslide-check.1" "${folder}/steadyslide-check.1.in" @ONLY)
  # The variable is for the build with sanitizers.
  set(program ${CMAKE_COMMAND} -E env "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/cmake/leaks.supp"
              $<TARGET_FILE:steadyslide>)
  add_custom_command(OUTPUT "${folder}/steadyslide.1.gz" "${folder}/steadyslide-check.1.gz" "${folder}/steadyslide"
    COMMAND ${program} --generate man > "${folder}/steadyslide.1"
    COMMAND ${program} --generate bash > "${folder}/steadyslide"
    COMMAND ${CMAKE_COMMAND} -E copy steadyslide-check.1.in steadyslide-check.1
    COMMAND ${STEADYSLIDE_GZIP} -9nf steadyslide.1 steadyslide-check.1
    WORKING_DIRECTORY "${folder}"
    DEPENDS steadyslide "${folder}/steadyslide-check.1.in" VERBATIM)
  add_custom_target(manual ALL DEPENDS "${folder}/steadyslide.1.gz")
  install(FILES "${folder}/steadyslide.1.gz" "${folder}/steadyslide-check.1.gz"
          DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT program)
  install(FILES "${folder}/steadyslide"
          DESTINATION "${CMAKE_INSTALL_DATAROOTDIR}/bash-completion/completions" COMPONENT program)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT program
          USE_SOURCE_PERMISSIONS PATTERN CMakeLists.txt EXCLUDE PATTERN __pycache__ EXCLUDE)
endfunction()

include(CMakePackageConfigHelpers)
set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/steadyslide")

# The public headers are found at the time of installation.
set(public_folders "")
foreach(layer IN ITEMS model symbolic statements numeric enclosure proofs_checks)
  if(TARGET steadyslide_${layer})
    install(TARGETS steadyslide_${layer} EXPORT steadyslideTargets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
    list(APPEND public_folders ${layer})
  endif()
endforeach()
list(JOIN public_folders "|" public_folders)
install(CODE "
  include(\"${CMAKE_CURRENT_LIST_DIR}/PublicHeaders.cmake\")
  steadyslide_public_headers(\"${PROJECT_SOURCE_DIR}\" headers)
  file(GLOB model RELATIVE \"${PROJECT_SOURCE_DIR}\" \"${PROJECT_SOURCE_DIR}/model/*.hpp\")
  list(APPEND headers \${model})
  list(REMOVE_DUPLICATES headers)
  list(FILTER headers INCLUDE REGEX \"^(${public_folders})/\")
  foreach(header IN LISTS headers)
    cmake_path(GET header PARENT_PATH folder)
    set(to \"${CMAKE_INSTALL_INCLUDEDIR}/steadyslide/\${folder}\")
    cmake_path(ABSOLUTE_PATH to BASE_DIRECTORY \"\${CMAKE_INSTALL_PREFIX}\")
    file(INSTALL \"${PROJECT_SOURCE_DIR}/\${header}\" DESTINATION \"\${to}\")
  endforeach()")
# The facade: include/steadyslide/steadyslide.hpp beside the layers' headers.
if(TARGET steadyslide_shared)
  install(TARGETS steadyslide_shared EXPORT steadyslideTargets
          LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT library NAMELINK_COMPONENT development)
  install(FILES "${PROJECT_SOURCE_DIR}/library/steadyslide/steadyslide.hpp"
          DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/steadyslide")
  install(FILES "${PROJECT_SOURCE_DIR}/library/answer/quantities.hpp"
          DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/steadyslide/library/answer")
  # The paths are relative, so that the installed tree can be moved.
  file(RELATIVE_PATH prefix_from_pc "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
  file(RELATIVE_PATH libdir_from_prefix "${CMAKE_INSTALL_PREFIX}" "${CMAKE_INSTALL_FULL_LIBDIR}")
  file(RELATIVE_PATH includedir_from_prefix "${CMAKE_INSTALL_PREFIX}" "${CMAKE_INSTALL_FULL_INCLUDEDIR}")
  configure_file("${CMAKE_CURRENT_LIST_DIR}/steadyslide.pc.in" "${CMAKE_CURRENT_BINARY_DIR}/steadyslide.pc" @ONLY)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/steadyslide.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endif()
foreach(program IN ITEMS steadyslide steadyslide-check)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT program)
  endif()
endforeach()
if(TARGET steadyslide-sweep)
  install(TARGETS steadyslide-sweep RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT sweep)
endif()
if(TARGET steadyslide)
  steadyslide_install_manual()
endif()

install(EXPORT steadyslideTargets NAMESPACE steadyslide:: DESTINATION "${package_dir}")
configure_package_config_file(
  "${CMAKE_CURRENT_LIST_DIR}/steadyslideConfig.cmake.in" "${CMAKE_CURRENT_BINARY_DIR}/steadyslideConfig.cmake"
  INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/steadyslideConfigVersion.cmake"
                                 COMPATIBILITY SameMajorVersion)
install(FILES
          "${CMAKE_CURRENT_BINARY_DIR}/steadyslideConfig.cmake"
          "${CMAKE_CURRENT_BINARY_DIR}/steadyslideConfigVersion.cmake"
          "${CMAKE_CURRENT_LIST_DIR}/FindArb.cmake"
          "${CMAKE_CURRENT_LIST_DIR}/SteadyslideDependencies.cmake"
        DESTINATION "${package_dir}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" COMPONENT license)
