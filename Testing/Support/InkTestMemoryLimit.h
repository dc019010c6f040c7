// SPDX-License-Identifier: BSD-3-Clause
#ifndef InkTestMemoryLimit_h
#define InkTestMemoryLimit_h

#include <fstream>

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

/// While it lives, the process gets no more than so many bytes of memory beyond what it has.
class InkTestMemoryLimit
{
public:
  explicit InkTestMemoryLimit(rlim_t bytes)
  {
    malloc_trim(0); // what was freed before would do
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    getrlimit(RLIMIT_AS, &this->Before);
    rlimit limit = this->Before;
    limit.rlim_cur = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + bytes;
    this->Set = pages > 0 && setrlimit(RLIMIT_AS, &limit) == 0;
  }
  ~InkTestMemoryLimit() { setrlimit(RLIMIT_AS, &this->Before); }
  InkTestMemoryLimit(const InkTestMemoryLimit&) = delete;
  InkTestMemoryLimit& operator=(const InkTestMemoryLimit&) = delete;

  bool IsSet() const { return this->Set; }

private:
  rlimit Before{};
  bool Set = false;
};

/// The sanitizers' own memory does not come from what the limit allows.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool InkTestCanLimitMemory = false;
#else
inline constexpr bool InkTestCanLimitMemory = true;
#endif

#endif
