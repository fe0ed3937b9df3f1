# Files of cases/ inside the program: `porefines validate` runs the same cases that cases/ shows.
set(shipped
  filter_cake/case.toml filter_cake/sieve.txt
  settling_sphere/case.toml settling_sphere/sphere.csv
  throat/case.toml throat/fine.csv throat/pillars.txt throat/bridging.toml throat/funnel.txt
  tube_migration/case.toml tube_migration/inside.csv tube_migration/outside.csv tube_migration/tube.png
  tumbling/case.toml tumbling/spheres.csv
  wet_impact/case.toml wet_impact/sphere.csv)
set(PF_SHIPPED_FILES "")
foreach(name ${shipped})
  set(path ${PROJECT_SOURCE_DIR}/cases/${name})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
  file(READ ${path} bytes HEX)
  string(LENGTH "${bytes}" digits)
  math(EXPR size "${digits} / 2")
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${bytes}")
  string(APPEND PF_SHIPPED_FILES "    {\"${name}\", {\"${bytes}\", ${size}}},\n")
endforeach()
configure_file(${PROJECT_SOURCE_DIR}/src/validate/shipped.cpp.in ${PROJECT_BINARY_DIR}/shipped.cpp @ONLY)
target_sources(pf_validate PRIVATE ${PROJECT_BINARY_DIR}/shipped.cpp)
