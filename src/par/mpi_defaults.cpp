// SPDX-License-Identifier: MPL-2.0
#include "par/mpi_defaults.hpp"

#include <cstdlib>

namespace porefines::par {

// No other thread has begun.
// NOLINTBEGIN(concurrency-mt-unsafe)
namespace {

void unless_given(const char* name, const char* value) {
  ::setenv(name, value, 0);
}

}  // namespace

void set_mpi_defaults() {
  // Started alone, Open MPI would start a daemon for processes to come: none do, and it costs 0.1 s.
  unless_given("OMPI_MCA_ess_singleton_isolated", "1");
  // All such processes would make and remove one folder in /tmp, and fail where two of them meet.
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr && std::getenv("PMIX_RANK") == nullptr) {
    unless_given("OMPI_MCA_orte_create_session_dirs", "0");
  }
  // Nobody shares a file pointer, and two runs at a time would complain of each other's.
  unless_given("OMPI_MCA_sharedfp", "^sm");
  // Halos of particles are some 20 kB: above 4 kB each would wait for an answer, 5 us a message.
  unless_given("OMPI_MCA_btl_vader_eager_limit", "65536");
  unless_given("OMPI_MCA_btl_vader_max_send_size", "131072");
}
// NOLINTEND(concurrency-mt-unsafe)

}  // namespace porefines::par
