#pragma once

#include <sys/mman.h>

#include <cstddef>
#include <new>

namespace umbral::raytrace {

/// Memory for arrays that may be hundreds of megabytes and are read in no order: large ones begin at a large page and
/// ask the system for such pages, so that the processor has fewer addresses to translate. Where there are none, nothing
/// but time is lost.
template <class T>
struct LargePages {
    using value_type = T;

    LargePages() = default;
    template <class U>
    explicit LargePages(const LargePages<U>& /*other*/) noexcept
    {
    }

    static constexpr std::size_t page = std::size_t{2} << 20U;

    [[nodiscard]] T* allocate(std::size_t count)
    {
        void* memory = ::operator new(count * sizeof(T), alignment(count));
        if (is_large(count)) (void)madvise(memory, count * sizeof(T), MADV_HUGEPAGE);
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t count) noexcept { ::operator delete(memory, alignment(count)); }

    friend bool operator==(const LargePages& /*a*/, const LargePages& /*b*/) { return true; }

private:
    static bool is_large(std::size_t count) { return count * sizeof(T) >= page; }
    static std::align_val_t alignment(std::size_t count)
    {
        return std::align_val_t{is_large(count) ? page : alignof(T)};
    }
};

}
