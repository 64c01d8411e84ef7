#include "tests/engine/output/failing_disk.hpp"

#include <fcntl.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <optional>

// HDF5 is a shared library and finds these functions before those of libc. They behave as file
// systems that cannot reserve space, which is the harder case.

namespace pliant::test {
namespace {

std::optional<Fault> injected;
long faulty_change = 0, changes_made = 0;
bool reservations_find_a_full_disk = false;

/// Whether the call must fail.
bool meets_fault() {
  const auto number = changes_made++;
  if (!injected || number < faulty_change) return false;
  if (*injected == Fault::kill) ::raise(SIGKILL);
  return *injected == Fault::disk_full;
}

int fail(int error_number) {
  errno = error_number;
  return -1;
}

}  // namespace

void inject(Fault fault, long number) {
  injected = fault;
  faulty_change = number;
  changes_made = 0;
}

void repair() { injected.reset(); }

void answer_reservations(bool disk_full) { reservations_find_a_full_disk = disk_full; }

}  // namespace pliant::test

using namespace pliant::test;

extern "C" {

ssize_t pwrite(int file, const void* bytes, size_t size, off_t offset) {
  if (meets_fault()) return fail(ENOSPC);
  return syscall(SYS_pwrite64, file, bytes, size, offset);
}

int ftruncate(int file, off_t size) noexcept {
  if (meets_fault()) return fail(ENOSPC);
  return static_cast<int>(syscall(SYS_ftruncate, file, size));
}

int rename(const char* from, const char* to) noexcept {
  if (meets_fault()) return fail(ENOSPC);
  return static_cast<int>(syscall(SYS_rename, from, to));
}

/// Removing a file needs no space on the disk.
int unlink(const char* path) noexcept {
  if (injected == Fault::kill) meets_fault();
  return static_cast<int>(syscall(SYS_unlink, path));
}

/// These tests are not about the cache of the disk, and flushing it would make them slow.
int fsync(int) { return 0; }

int fallocate(int, int, off_t, off_t) {
  return fail(reservations_find_a_full_disk ? ENOSPC : EOPNOTSUPP);
}

}  // extern "C"
