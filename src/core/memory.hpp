// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace porefines {

/// Largest resident memory of this process so far [bytes] (VmHWM); 0 when Linux does not say.
[[nodiscard]] std::int64_t peak_memory();

/// Memory that this process can still take [bytes]: what the machine has free for use (MemAvailable)
/// or what its control group leaves (container, batch system), whichever is less.
/// The largest number there is when neither is known.
[[nodiscard]] std::int64_t available_memory();

/// The number behind `key` in lines such as "VmHWM:   1234 kB" [bytes].
[[nodiscard]] std::optional<std::int64_t> read_kilobytes(std::string_view text,
                                                         std::string_view key);

/// What the control group files under `folder` leave [bytes]: limit - use + reclaimable page cache.
/// Knows version 2 (memory.max) and version 1 (memory.limit_in_bytes). Empty without a limit.
[[nodiscard]] std::optional<std::int64_t> control_group_room(const std::string& folder);

/// "12.3 GiB", "640 MiB", for messages.
[[nodiscard]] std::string format_bytes(std::int64_t bytes);

/// Gives memory that was freed back to the system: with Open MPI the heap keeps it otherwise.
void give_back_memory();

}  // namespace porefines
