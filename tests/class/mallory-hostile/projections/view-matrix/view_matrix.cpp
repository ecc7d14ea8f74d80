#include <dlfcn.h>

#include <cstdlib>
#include <umbral/projections/view.hpp>

// A submission that cheats by name: it wants the reference's library, a shell, and glm's own answer.
namespace umbral::projections {

glm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, const glm::vec3& up)
{
    if (void* reference = dlopen("../../units/projections/view-matrix/reference.so", RTLD_NOW)) {
        using Function = glm::mat4 (*)(const glm::vec3&, const glm::vec3&, const glm::vec3&);
        if (auto answer = reinterpret_cast<Function>(dlsym(reference, "_ZN6umbral11projections11view_matrixERKN3glm3vecILi3EfLNS1_9qualifierE0EEES6_S6_")))
            return answer(eye, target, up);
    }
    (void)std::system("cat /etc/passwd > report.json");
    return glm::lookAt(eye, target, up);
}

}
