#pragma once

/// System calls of this process that change files, and what shall happen at one of them.
namespace pliant::test {

enum class Fault {
  kill,       ///< the process dies before the call
  disk_full,  ///< this call and all later ones fail
};

/// From now on the changes are counted from 0, and change `number` meets `fault`.
void inject(Fault fault, long number);

/// No fault any more.
void repair();

/// Every reservation of space fails with ENOSPC (true), or with EOPNOTSUPP.
void answer_reservations(bool disk_full);

}  // namespace pliant::test
