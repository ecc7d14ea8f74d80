#include "render/fields/fields.hpp"

#include "render/fields/shapes.hpp"

namespace umbral::render::fields {

Distance field_of(scene::FieldKind kind)
{
    switch (kind) {
        case scene::FieldKind::mandelbulb: break;
    }
    return mandelbulb;
}

}
