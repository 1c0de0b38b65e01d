/**
 * The client's own ground, in the game TerrainManager.getTerrainHeight: metres above the body's radius along the unit
 * direction (nx, ny, nz) in the body's axes (Y pole, Z prime meridian, X 90° E).
 */
export function terrainHeight(bodyName, nx, ny, nz) {
  return bodyName === 'Luna' ? 0.02 * Math.sin(4e5 * nx) * Math.sin(4e5 * ny) * Math.sin(4e5 * nz) : 0;
}
