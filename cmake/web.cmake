# The page of `porefines report`: npm fetches what web/package-lock.json names, esbuild makes one HTML
# file of it, and src/page/bundle.S puts that into the program. No network afterwards.
find_program(PF_NPM npm REQUIRED)
find_program(PF_NODE node REQUIRED)
set(web ${PROJECT_BINARY_DIR}/web)
file(GLOB_RECURSE web_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/web/src/*)
set(web_scripts ${PROJECT_SOURCE_DIR}/web/build.mjs)
set(web_packages ${PROJECT_SOURCE_DIR}/web/package.json ${PROJECT_SOURCE_DIR}/web/package-lock.json)

add_custom_command(OUTPUT ${web}/packages.stamp
  COMMAND ${CMAKE_COMMAND} -E make_directory ${web}
  COMMAND ${CMAKE_COMMAND} -E copy ${web_packages} ${web}
  COMMAND ${PF_NPM} ci --ignore-scripts --no-audit --no-fund --loglevel=error --prefix ${web}
  COMMAND ${CMAKE_COMMAND} -E touch ${web}/packages.stamp
  DEPENDS ${web_packages} WORKING_DIRECTORY ${web} COMMENT "Fetching the page's libraries" VERBATIM)
add_custom_command(OUTPUT ${web}/page.html
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${web}/src
  COMMAND ${CMAKE_COMMAND} -E copy_directory ${PROJECT_SOURCE_DIR}/web/src ${web}/src
  COMMAND ${CMAKE_COMMAND} -E copy ${web_scripts} ${web}
  COMMAND ${PF_NODE} build.mjs
  DEPENDS ${web_sources} ${web_scripts} ${web}/packages.stamp
  WORKING_DIRECTORY ${web} COMMENT "Building the page of reports" VERBATIM)
add_custom_target(pf_web DEPENDS ${web}/page.html)

enable_language(ASM)
set(bundle ${PROJECT_SOURCE_DIR}/src/page/bundle.S)
set_source_files_properties(${bundle} PROPERTIES OBJECT_DEPENDS ${web}/page.html
  COMPILE_DEFINITIONS "PF_PAGE=\"${web}/page.html\"")
target_sources(pf_page PRIVATE ${bundle})
add_dependencies(pf_page pf_web)
