# Up is made perpendicular the wrong way round.
s/const glm::dvec3 side = cross(u, z)/const glm::dvec3 side = cross(z, u)/
