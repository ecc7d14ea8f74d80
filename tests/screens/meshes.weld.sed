# Places are told apart by x and y alone.
s/std::bit_cast<std::uint32_t>(p.z + 0.0F)/0U/
