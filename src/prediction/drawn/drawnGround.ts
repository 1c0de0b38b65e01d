import type { Body, World } from '../../dynamics';

const place: { body: Pick<Body, 'name' | 'radius'>; height: World['terrainHeight'] } = {
  body: { name: '', radius: 0 },
  height: () => 0,
};

/** Chooses the ground that groundRadius tells of. */
export function layGround(body: Pick<Body, 'name' | 'radius'>, height: World['terrainHeight']): void {
  place.body = body;
  place.height = height;
}

/**
 * GroundRadius of the ground laid last. One function for whatever is stood: where several were called in one place, each call
 * boxed its four doubles.
 */
export function groundRadius(nx: number, ny: number, nz: number): number {
  return place.body.radius + place.height(place.body.name, nx, ny, nz);
}
