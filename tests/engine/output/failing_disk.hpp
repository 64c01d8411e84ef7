#pragma once

/// Intercepts the system calls of this process that change files, and injects faults.
namespace pliant::test {

enum class Fault {
  kill,       ///< the process dies before the call
  disk_full,  ///< this call and all later ones fail
};

/// Changes are counted from 0 from now on; `fault` happens at change `number`.
void inject(Fault fault, long number);

/// Removes the fault.
void repair();

/// Makes every reservation of space fail, with ENOSPC if `disk_full`, else with EOPNOTSUPP.
void answer_reservations(bool disk_full);

}  // namespace pliant::test
