"""python3 record_landing.py FILE: records three seconds of a manually flown landing from its own service."""

import subprocess
import sys

from harness import PATIENCE, SERVICE_HOME, RedisServer, ServiceProcess, control, lander, result_of, send, until


def main() -> None:
    redis = RedisServer()
    service = None
    try:
        client = redis.client()
        client.mset({"game:tick_rate": "50", "game:time_scale": "2"})
        service = ServiceProcess(redis)
        entry = send(client, "spawn", **lander(height=50, velocity=[3, 0, -12], tilt=10))
        until(lambda: result_of(client, entry), "the ship is there", service)
        client.set("game:paused", "true")
        until(lambda: client.hget("touchdown:clock", "paused") == "true", "it is paused", service)
        now = int(client.get("game:tick"))
        for seq in range(1, 9):
            controls = {"thrust_level": 0.01 * seq, "attitude_mode": "radial" if seq % 2 else "hold"}
            control(client, seq, controls, tick=now + 100 + 9 * seq, substep=seq % 4)
        command = [sys.executable, "-m", "touchdown_service.recorder", "--redis", redis.url]
        child = subprocess.Popen([*command, "--ship", "s1", "--ticks", "300", sys.argv[1]], cwd=SERVICE_HOME)
        # It waits for the next frame.
        until(lambda: client.info("clients")["blocked_clients"] == 1, "the recorder listens", service)
        client.set("game:paused", "false")
        if child.wait(PATIENCE) != 0:
            sys.exit("the recorder failed")
    finally:
        if service:
            service.close()
        redis.close()


if __name__ == "__main__":
    main()
