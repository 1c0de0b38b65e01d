import 'galaxy-touchdown/hud.css';
import './example.css';
import { createControls } from './controls.js';
import { createCockpitExtrapolation } from './cockpitExtrapolation.js';
import { createLandingHud } from './cockpitLandingHud.js';
import { createScene } from './cockpitScene.js';
import { createFleet } from './fleetHud.js';

const part = (id) => document.getElementById(id);
const say = (text) => (part('link').textContent = text);

/** The game's login: its address and who plays are in the page's, ?server=http://127.0.0.1:8080&user=ada&password=… */
async function signIn(query) {
  const server = query.get('server') ?? 'http://127.0.0.1:8080';
  const body = JSON.stringify({ username: query.get('user') ?? '', password: query.get('password') ?? '' });
  const answer = await fetch(`${server}/api/auth/login`, { method: 'POST', body });
  const { token, ship_id: shipId, error } = await answer.json();
  if (error !== undefined) throw new Error(error.message);
  return { address: `${server.replace(/^http/, 'ws')}/ws`, token, shipId };
}

async function begin() {
  const session = await signIn(new URLSearchParams(location.search));
  const { frame } = createCockpitExtrapolation({ ...session, onStatus: say });
  const controls = createControls(window);
  const shows = [createScene(part('scene')), createLandingHud(part('landing')), createFleet(part('fleet'))];
  requestAnimationFrame(function draw() {
    const view = frame(controls());
    for (const show of shows) show(view);
    requestAnimationFrame(draw);
  });
}

begin().catch((error) => say(`Cannot begin: ${error.message}`));
