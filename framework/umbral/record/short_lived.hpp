#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <tuple>
#include <utility>

namespace umbral {

/// Copies of arguments that are gone, and overwritten, when this is: whoever kept a reference to one of them reads what
/// cannot be right. (As variables of a driver they would stay readable for as long as the case lasts.)
template <class... Arguments>
class ShortLived {
public:
    explicit ShortLived(const Arguments&... arguments) : bytes_(std::make_unique<std::byte[]>(room))
    {
        std::size_t left = room;
        void* place = bytes_.get();
        place = std::align(alignof(Values), sizeof(Values), place, left);
        values_ = new (place) Values(arguments...);
    }
    ~ShortLived()
    {
        std::destroy_at(values_);
        // A NaN as a float and as a double; volatile, or compilers leave out what nothing reads.
        std::fill_n(static_cast<volatile std::byte*>(bytes_.get()), room, std::byte{0xff});
    }
    ShortLived(const ShortLived&) = delete;
    ShortLived& operator=(const ShortLived&) = delete;

    /// What `function` returns for the copies.
    template <class Function>
    decltype(auto) apply(Function&& function) const
    {
        return std::apply(std::forward<Function>(function), static_cast<const Values&>(*values_));
    }

private:
    using Values = std::tuple<Arguments...>;
    static constexpr std::size_t room = sizeof(Values) + alignof(Values);

    std::unique_ptr<std::byte[]> bytes_;
    Values* values_;
};

}
