// SPDX-License-Identifier: MPL-2.0
// What FieldWriter writes opens in VTK, with the right axes: cells, spacing and values differ in
// x, y and z. The numbers here are repeated in vtk_reader_check.py.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "io/fields.hpp"

namespace porefines {
namespace {

constexpr Int3 cells{7, 5, 3};

void write_example(const std::string& folder) {
  const io::GridBlock grid{cells, {1e-3, -2e-3, 5e-4}, {1e-6, 2e-6, 4e-6}, {0, 0, 0}, cells};
  io::FieldWriter writer(folder, MPI_COMM_SELF, grid, io::make_provenance(1, 7));
  for (const double time : {0.0, 0.25}) {
    std::vector<float> pressure;
    std::vector<float> velocity;
    for (int k = 0; k < cells[2]; ++k) {
      for (int j = 0; j < cells[1]; ++j) {
        for (int i = 0; i < cells[0]; ++i) {
          pressure.push_back(static_cast<float>(100 * time + i + 10 * j + 100 * k));
          velocity.insert(velocity.end(), {i + 0.5f, -1.0f * j, static_cast<float>(time + k)});
        }
      }
    }
    const io::ScalarField scalars[] = {{"pressure", pressure}};
    const io::VectorField vectors[] = {{"velocity", velocity}};
    writer.write(time, scalars, vectors);
  }
}

struct Outcome {
  int code = -1;
  std::string output;
};

Outcome run(const std::string& command) {
  Outcome outcome;
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) {
    return outcome;
  }
  char buffer[512];
  while (std::fgets(buffer, sizeof buffer, pipe) != nullptr) {
    outcome.output += buffer;
  }
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

TEST(vtk_reader, sees_the_grid_and_the_values) {
  const char* chosen = std::getenv("PF_VTK_PYTHON");
  const std::string python = chosen != nullptr ? chosen : "/usr/bin/python3";
  const std::string script = python + " " PF_SOURCE_DIR "/tests/cli/vtk_reader_check.py ";
  if (run(script + "--list").code != 0) {
    GTEST_SKIP() << python << " has no VTK with an XDMF reader: apt-get install python3-paraview";
  }
  const std::string folder = ::testing::TempDir() + "pf_vtk_reader";
  std::filesystem::create_directories(folder);
  write_example(folder);
  const Outcome outcome = run(script + folder);
  EXPECT_EQ(outcome.code, 0) << outcome.output;
  std::printf("%s", outcome.output.c_str());
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace porefines
