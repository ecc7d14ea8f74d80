#include "../calls.hpp"

namespace umbral::bench {

std::vector<stability::Call> all_calls()
{
    std::vector<stability::Call> all;
    for (const auto& topic :
         {transforms_calls(), projections_calls(), lighting_calls(), raytracing_calls(), texturing_calls()})
        all.insert(all.end(), topic.begin(), topic.end());
    return all;
}

}
