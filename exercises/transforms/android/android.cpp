#include <umbral/transforms/android.hpp>

namespace umbral::transforms {

std::unique_ptr<Android> make_android()
{
    // TODO: above this function, write a class that derives from Android: it keeps three angles, and draws the parts
    // one after the other. Write a function for the limb first: you need it four times. Return
    // std::make_unique<YourClass>().
    return not_implemented<std::unique_ptr<Android>>();
}

}
