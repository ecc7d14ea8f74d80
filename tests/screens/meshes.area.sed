# The first triangle is added twice.
s/double sum = 0;/double sum = mesh.triangles.empty() ? 0 : area_of(mesh.positions[mesh.triangles[0].x], mesh.positions[mesh.triangles[0].y], mesh.positions[mesh.triangles[0].z]);/
