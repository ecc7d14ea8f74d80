#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace umbral::grader {

/// Values that several threads remember together: each is made once, by whoever asks for it first, and who asks
/// meanwhile waits for it. What was not asked for lately is forgotten first.
template <class Value>
class MadeOnce {
public:
    using Pointer = std::shared_ptr<const Value>;

    /// Remembers values of about `most` bytes together, as `bytes_of` counts them.
    MadeOnce(std::size_t most, std::function<std::size_t(const Value&)> bytes_of)
        : most_(most), bytes_of_(std::move(bytes_of))
    {
    }

    /// The value that this key stands for, made by `make` if nobody has yet. What `make` throws all get who wait for
    /// it; it is tried again for the next. `make` may ask for other values, as long as none of these asks for this one.
    template <class Make>
    [[nodiscard]] Pointer get(const std::string& key, const Make& make)
    {
        std::promise<Pointer> promise;
        std::shared_future<Pointer> others;
        {
            const std::lock_guard lock(mutex_);
            others = remembered(key);
            if (!others.valid()) lately_.emplace(key, Entry{promise.get_future().share()});
        }
        if (others.valid()) return others.get();
        try {
            Pointer value = std::make_shared<const Value>(make());
            promise.set_value(value);
            count(key, bytes_of_(*value));
            return value;
        } catch (...) {
            forget(key);
            promise.set_exception(std::current_exception());
            throw;
        }
    }

    /// It is made again for the next who asks.
    void forget(const std::string& key)
    {
        const std::lock_guard lock(mutex_);
        lately_.erase(key);
        earlier_.erase(key);
    }

private:
    struct Entry {
        std::shared_future<Pointer> made;
        std::size_t bytes = 0;
    };

    /// What is asked for again is of those that were asked for lately. Not valid if there is none.
    std::shared_future<Pointer> remembered(const std::string& key)
    {
        if (const auto found = lately_.find(key); found != lately_.end()) return found->second.made;
        auto before = earlier_.extract(key);
        if (before.empty()) return {};
        const Entry entry = before.mapped();
        lately_.insert(std::move(before));
        add(entry.bytes);
        return entry.made;
    }

    void count(const std::string& key, std::size_t bytes)
    {
        const std::lock_guard lock(mutex_);
        const auto place = lately_.find(key);
        if (place == lately_.end()) return;  // of those before, by now
        place->second.bytes = bytes;
        add(bytes);
    }

    /// Who waits for one that is being made holds its future.
    void add(std::size_t bytes)
    {
        bytes_ += bytes;
        if (bytes_ <= most_ / 2) return;
        earlier_ = std::exchange(lately_, {});
        bytes_ = 0;
    }

    std::size_t most_;
    std::function<std::size_t(const Value&)> bytes_of_;
    std::mutex mutex_;
    std::map<std::string, Entry> lately_;
    std::map<std::string, Entry> earlier_;
    std::size_t bytes_ = 0;  ///< of those that were asked for lately
};

}
