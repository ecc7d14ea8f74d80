#include "run/last_words.hpp"

#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <link.h>
#include <linux/audit.h>
#include <signal.h>
#include <sys/auxv.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <initializer_list>
#include <new>
#include <umbral/core/student_error.hpp>

#include "run/emulated_calls.hpp"
#include "run/sandbox.hpp"

namespace umbral::grader::last_words {
namespace {

// A signal handler has no argument of ours: the header of this process's one run is the one thing that must be
// reachable from it.
wire::Header* noted = nullptr;
std::uintptr_t stack_end = ~std::uintptr_t{0};

constexpr int exit_after_crash = 70;
constexpr std::uintptr_t stack_guard = std::uintptr_t{256} << 10U;
constexpr std::uintptr_t largest_frame = std::uintptr_t{1} << 20U;

void set_text(wire::Header& header, std::initializer_list<const char*> parts) noexcept
{
    std::size_t used = 0;
    for (const char* part : parts) {
        const std::size_t size = std::min(std::strlen(part), sizeof header.text - 1 - used);
        std::memcpy(header.text + used, part, size);
        used += size;
    }
    header.text[used] = 0;
}

void note_frames(wire::Header& header) noexcept
{
    std::array<void*, 32> addresses{};
    const int count = backtrace(addresses.data(), static_cast<int>(addresses.size()));
    header.frame_count = static_cast<std::uint32_t>(std::max(0, count));
    for (std::uint32_t i = 0; i < header.frame_count; ++i)
        header.frames[i] =
            reinterpret_cast<std::uintptr_t>(addresses[i]) - static_cast<std::uintptr_t>(header.library_base);
}

void put_first(wire::Header& header, std::uint64_t frame) noexcept
{
    const std::size_t kept = std::min<std::size_t>(header.frame_count, std::size(header.frames) - 1);
    std::copy_backward(header.frames, header.frames + kept, header.frames + kept + 1);
    header.frames[0] = frame;
    header.frame_count = static_cast<std::uint32_t>(kept + 1);
}

struct Registers {
    std::uintptr_t stack;
    std::uintptr_t program;
};
Registers registers_of(const ucontext_t& context)
{
#if defined(__x86_64__)
    return {static_cast<std::uintptr_t>(context.uc_mcontext.gregs[REG_RSP]),
            static_cast<std::uintptr_t>(context.uc_mcontext.gregs[REG_RIP])};
#elif defined(__aarch64__)
    return {context.uc_mcontext.sp, context.uc_mcontext.pc};
#endif
}

/// Where the stack ends: the kernel puts the program's name last.
std::uintptr_t find_stack_end()
{
    const auto name = static_cast<std::uintptr_t>(getauxval(AT_EXECFN));
    if (name == 0) return ~std::uintptr_t{0};
    const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
    return (name + std::strlen(reinterpret_cast<const char*>(name)) + page) & ~(page - 1);
}

/// Did a function return to an address that is none, as after an array was written over its own return address? Reads
/// the stack, which may be anywhere.
bool returned_to_nowhere([[maybe_unused]] const siginfo_t& info, [[maybe_unused]] const Registers& registers)
{
#if defined(__x86_64__)
    constexpr unsigned char return_instruction = 0xC3;
    // An address that no pointer can have is refused at the return itself; another one, where it leads.
    if (info.si_code == SI_KERNEL)
        return *reinterpret_cast<const unsigned char*>(registers.program) == return_instruction;
    const bool jumped = reinterpret_cast<std::uintptr_t>(info.si_addr) == registers.program;
    return jumped &&
           *reinterpret_cast<const std::uintptr_t*>(registers.stack - sizeof(std::uintptr_t)) == registers.program;
#else
    return false;
#endif
}

void note_signal(wire::Header& header, int signal, const siginfo_t& info, const Registers& registers)
{
    // First, so that a crash while reading below ends here.
    header.note = static_cast<std::uint32_t>(wire::Note::signal);
    // As students' files are compiled (cmake/UmbralUnit.cmake), these end the program; so does what the compiler has
    // seen to be a use of no object.
    if (signal == SIGILL || signal == SIGTRAP)
        set_text(header, {"an index outside of an array, a function that ended without giving its result, or a "
                          "null pointer"});
    if (signal != SIGSEGV) return;
    const auto fault = reinterpret_cast<std::uintptr_t>(info.si_addr);
    const bool beyond = fault >= stack_end && fault < stack_end + stack_guard;
    const bool near_stack = !beyond && fault + stack_guard > registers.stack && fault < registers.stack + largest_frame;
    if (near_stack)
        header.note = static_cast<std::uint32_t>(wire::Note::stack_overflow);
    else if (beyond || returned_to_nowhere(info, registers))
        set_text(header, {"an array on the stack was written beyond its end"});
}

void crashed(int signal, const siginfo_t* info, const ucontext_t& context) noexcept
{
    wire::Header& header = *noted;
    const Registers registers = registers_of(context);
    header.signal = static_cast<std::uint32_t>(signal);
    if (header.note == static_cast<std::uint32_t>(wire::Note::none)) note_signal(header, signal, *info, registers);
    // A jump to nowhere leaves no frame of its own, and of others the instruction itself is known: it comes first.
    if (header.frame_count == 0) {
        const std::uint64_t program = registers.program - static_cast<std::uintptr_t>(header.library_base);
        header.frames[0] = program;
        header.frame_count = 1;
        if (header.note != static_cast<std::uint32_t>(wire::Note::stack_overflow)) {
            note_frames(header);
            put_first(header, program);
        }
    }
    _exit(exit_after_crash);
}

void on_crash(int signal, siginfo_t* info, void* context) { crashed(signal, info, *static_cast<ucontext_t*>(context)); }

#if defined(__x86_64__)
constexpr unsigned own_architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned own_architecture = AUDIT_ARCH_AARCH64;
#endif

emulated_calls::Arguments arguments_of(const ucontext_t& context)
{
    const auto& machine = context.uc_mcontext;
    const auto word = [](auto value) { return static_cast<std::uint64_t>(value); };
#if defined(__x86_64__)
    return {word(machine.gregs[REG_RDI]), word(machine.gregs[REG_RSI]), word(machine.gregs[REG_RDX]),
            word(machine.gregs[REG_R10])};
#elif defined(__aarch64__)
    return {word(machine.regs[0]), word(machine.regs[1]), word(machine.regs[2]), word(machine.regs[3])};
#endif
}

void set_result(ucontext_t& context, std::int64_t result)
{
#if defined(__x86_64__)
    context.uc_mcontext.gregs[REG_RAX] = result;
#elif defined(__aarch64__)
    context.uc_mcontext.regs[0] = static_cast<std::uint64_t>(result);
#endif
}

// The filter turns every system call that is not listed into SIGSYS: but for the few that are emulated it is noted, and
// fails with EPERM.
void on_refused_call(int, siginfo_t* info, void* raw_context)
{
    const int saved_errno = errno;
    auto& context = *static_cast<ucontext_t*>(raw_context);
    const bool own = info->si_arch == own_architecture;
    const std::uint32_t call = static_cast<std::uint32_t>(info->si_syscall) | (own ? 0 : sandbox::other_architecture);
    const emulated_calls::Arguments arguments = arguments_of(context);
    // abort() signals itself: that is a crash to be told with its place, not an attack.
    if (call == SYS_tgkill && arguments[2] == SIGABRT) crashed(SIGABRT, info, context);
    if (const auto result = emulated_calls::answer(call, arguments)) {
        set_result(context, *result);
    } else {
        wire::Header& header = *noted;
        if (header.refused_count < std::size(header.refused)) header.refused[header.refused_count] = call;
        ++header.refused_count;
        set_result(context, -EPERM);
    }
    errno = saved_errno;
}

void on_terminate()
{
    note_exception(*noted);
    note_frames(*noted);
    _exit(exit_after_crash);
}

void handle(int signal, void (*handler)(int, siginfo_t*, void*))
{
    struct sigaction action {};
    action.sa_sigaction = handler;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
    sigaction(signal, &action, nullptr);
}

}

void listen(wire::Header& header)
{
    noted = &header;
    stack_end = find_stack_end();
    // backtrace loads the unwinder at its first call, which the sandbox would refuse later.
    std::array<void*, 2> first{};
    (void)backtrace(first.data(), 2);
    constexpr std::size_t size = std::size_t{128} << 10U;
    void* memory = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory != MAP_FAILED) {
        const stack_t stack{memory, 0, size};
        sigaltstack(&stack, nullptr);
    }
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP, SIGABRT}) handle(signal, on_crash);
    handle(SIGSYS, on_refused_call);
    signal(SIGXFSZ, SIG_IGN);
    std::set_terminate(on_terminate);
}

void set_library(wire::Header& header, const void* handle)
{
    const auto* map = static_cast<const link_map*>(handle);
    header.library_base = map->l_addr;
}

/// What is used as it must not be ends the case as any exception does.
wire::Note note_of(StudentError::Kind kind) noexcept
{
    switch (kind) {
        case StudentError::Kind::compile_error: return wire::Note::compile_error;
        case StudentError::Kind::interface_mismatch: return wire::Note::interface_mismatch;
        case StudentError::Kind::misuse: break;
    }
    return wire::Note::uncaught_exception;
}

void note_exception(wire::Header& header) noexcept
{
    const auto note = [&](wire::Note kind, std::initializer_list<const char*> parts) {
        header.note = static_cast<std::uint32_t>(kind);
        set_text(header, parts);
    };
    if (!std::current_exception()) return note(wire::Note::uncaught_exception, {"std::terminate was called"});
    try {
        throw;
    } catch (const StudentError& error) {
        note(note_of(error.kind()), {error.what()});
    } catch (const std::bad_alloc&) {
        note(wire::Note::out_of_memory, {"std::bad_alloc: no more memory"});
    } catch (const std::exception& error) {
        int status = 0;
        char* name = abi::__cxa_demangle(typeid(error).name(), nullptr, nullptr, &status);
        note(wire::Note::uncaught_exception,
             {"uncaught exception ", name != nullptr ? name : "of an unknown type", ": ", error.what()});
        std::free(name);
    } catch (...) {
        note(wire::Note::uncaught_exception, {"uncaught exception that is not a std::exception"});
    }
}

}
