// SPDX-License-Identifier: MPL-2.0
#include "geom/share.hpp"

#include <algorithm>
#include <cstring>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include "core/error.hpp"

namespace porefines::geom {

namespace {

int rank_in(MPI_Comm communicator) {
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  return rank;
}

/// Map `bytes` of the shared file; null when that fails.
std::uint8_t* map(const std::string& name, std::size_t bytes, bool create) {
  const int file = shm_open(name.c_str(), create ? O_RDWR | O_CREAT | O_EXCL : O_RDWR, 0600);
  if (file < 0) {
    return nullptr;
  }
  void* memory = MAP_FAILED;
  // posix_fallocate says now what would otherwise be a bus error later: /dev/shm may be small.
  if (!create || posix_fallocate(file, 0, static_cast<off_t>(bytes)) == 0) {
    memory = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  }
  close(file);
  return memory == MAP_FAILED ? nullptr : static_cast<std::uint8_t*>(memory);
}

/// One mapping for all ranks of this node, or null on all of them. Collective over `node`.
std::shared_ptr<std::uint8_t> map_on_node(std::size_t bytes, MPI_Comm node) {
  static int uses = 0;
  std::array<int, 2> id{static_cast<int>(getpid()), uses++};
  MPI_Bcast(id.data(), 2, MPI_INT, 0, node);
  const std::string name = fmt::format("/porefines_{}_{}", id[0], id[1]);
  const bool first = rank_in(node) == 0;
  std::uint8_t* memory = first ? map(name, bytes, true) : nullptr;
  MPI_Barrier(node);
  if (!first) {
    memory = map(name, bytes, false);
  }
  int fine = memory != nullptr ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &fine, 1, MPI_INT, MPI_MIN, node);
  if (first) {
    shm_unlink(name.c_str());  // the memory lives until the last rank lets go
  }
  const auto release = [bytes](std::uint8_t* p) { munmap(p, bytes); };
  if (memory == nullptr) {
    return nullptr;
  }
  std::shared_ptr<std::uint8_t> shared(memory, release);
  return fine != 0 ? shared : nullptr;
}

}  // namespace

void broadcast_bytes(void* data, std::size_t bytes, MPI_Comm communicator) {
  constexpr std::size_t piece = std::size_t{1} << 30;
  auto* at = static_cast<std::uint8_t*>(data);
  for (std::size_t done = 0; done < bytes; done += piece) {
    MPI_Bcast(at + done, static_cast<int>(std::min(piece, bytes - done)), MPI_BYTE, 0,
              communicator);
  }
}

void throw_everywhere(const std::string& text, MPI_Comm communicator) {
  auto length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, communicator);
  if (length == 0) {
    return;
  }
  std::string message = text;
  message.resize(static_cast<std::size_t>(length));
  broadcast_bytes(message.data(), message.size(), communicator);
  throw InputError(message);
}

namespace {

/// The bytes of rank 0, readable by all. Collective.
std::shared_ptr<const std::uint8_t> share_bytes(std::vector<std::uint8_t> mine, std::size_t bytes,
                                                MPI_Comm communicator) {
  int ranks = 1;
  MPI_Comm_size(communicator, &ranks);
  std::shared_ptr<std::uint8_t> memory;
  MPI_Comm leaders = MPI_COMM_NULL;
  bool copies = true;  // whether this rank takes part in the broadcast
  if (ranks > 1) {
    MPI_Comm node = MPI_COMM_NULL;
    MPI_Comm_split_type(communicator, MPI_COMM_TYPE_SHARED, rank_in(communicator), MPI_INFO_NULL,
                        &node);
    memory = map_on_node(bytes, node);
    int everywhere = memory ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &everywhere, 1, MPI_INT, MPI_MIN, communicator);
    if (everywhere == 0) {
      memory.reset();
    }
    copies = !memory || rank_in(node) == 0;
    MPI_Comm_split(communicator, copies ? 0 : MPI_UNDEFINED, rank_in(communicator), &leaders);
    MPI_Comm_free(&node);
  }
  if (!memory) {
    auto held = std::make_shared<std::vector<std::uint8_t>>(std::move(mine));
    held->resize(bytes);
    memory = std::shared_ptr<std::uint8_t>(held, held->data());
  } else if (rank_in(communicator) == 0) {
    std::memcpy(memory.get(), mine.data(), bytes);
  }
  if (leaders != MPI_COMM_NULL) {
    broadcast_bytes(memory.get(), bytes, leaders);
    MPI_Comm_free(&leaders);
  }
  if (ranks > 1) {
    MPI_Barrier(communicator);  // written before anyone reads
  }
  return memory;
}

}  // namespace

SharedVoxels share(Voxels mine, MPI_Comm communicator) {
  MPI_Bcast(mine.n.data(), 3, MPI_INT, 0, communicator);
  const auto bytes = static_cast<std::size_t>(product(mine.n));
  int grey = mine.share.empty() ? 0 : 1;
  MPI_Bcast(&grey, 1, MPI_INT, 0, communicator);
  SharedVoxels all{mine.n, share_bytes(std::move(mine.pore), bytes, communicator), nullptr};
  if (grey != 0) {
    all.share = share_bytes(std::move(mine.share), bytes, communicator);
  }
  return all;
}

}  // namespace porefines::geom
