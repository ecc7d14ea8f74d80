#include <gtest/gtest.h>
#include <linux/capability.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "run/sandbox.hpp"

namespace umbral::grader::test {
namespace {

/// Exit status of a fork that does this.
template <class Work>
int status_of(Work work)
{
    const pid_t child = fork();
    if (child == 0) _exit(work());
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

constexpr int soft_offline = 101;  // MADV_SOFT_OFFLINE, which the C library does not name

// madvise, which every program calls, takes pages away from the machine if root asks for it, and with the page of a
// recording the grader.
TEST(Capabilities, are_given_up_for_good)
{
    EXPECT_EQ(status_of([] {
                  sandbox::drop_privileges();
                  sandbox::drop_capabilities();
                  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
                  std::array<__user_cap_data_struct, _LINUX_CAPABILITY_U32S_3> left{};
                  if (syscall(SYS_capget, &header, left.data()) != 0) return 1;
                  if (std::ranges::any_of(left, [](const auto& one) { return (one.effective | one.permitted) != 0; }))
                      return 2;
                  void* page = mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
                  for (const int advice : {MADV_HWPOISON, soft_offline})
                      if (madvise(page, 4096, advice) == 0 || (errno != EPERM && errno != EINVAL)) return 3;
                  return 0;
              }),
              0);
}

// Grades must not follow from the shell that the grader was started from.
TEST(Limits, of_the_stack_are_the_same_whatever_they_were)
{
    for (const rlim_t before : {rlim_t{1} << 20U, rlim_t{1} << 26U})
        EXPECT_EQ(status_of([&] {
                      rlimit stack{};
                      getrlimit(RLIMIT_STACK, &stack);
                      stack.rlim_cur = std::min(stack.rlim_max, before);
                      if (setrlimit(RLIMIT_STACK, &stack) != 0) return 1;
                      sandbox::limit_resources({});
                      getrlimit(RLIMIT_STACK, &stack);
                      return stack.rlim_cur == std::min(stack.rlim_max, rlim_t{sandbox::ResourceLimits::stack}) ? 0 : 2;
                  }),
                  0);
}

}
}
