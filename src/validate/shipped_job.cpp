// SPDX-License-Identifier: MPL-2.0
#include "validate/shipped.hpp"

namespace porefines::validate {

Job shipped_job(const std::string& name, const std::string& folder, const std::string& case_file,
                const std::vector<std::string>& files, const std::vector<std::string>& set) {
  Job job{.name = name, .case_text = shipped(folder + "/" + case_file), .set = set};
  for (const std::string& file : files) {
    job.files.emplace_back(file, shipped(folder + "/" + file));
  }
  return job;
}

}  // namespace porefines::validate
