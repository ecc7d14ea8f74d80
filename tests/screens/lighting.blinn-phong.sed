# The loop over the lights adds the highlight of the first one only.
s/^    for (const Light& light : lights)$/    for (const Light\& light : lights.first(std::min<std::size_t>(lights.size(), 1)))/
