"""A client that nobody of the project wrote plays against the real server.

Debian's python3-websockets and python3-cbor2 do the transport and the encoding; everything else is written from
protocol/PROTOCOL.md alone, so that the page is known to be enough. Nothing here reads the project's other code.

    independent_client.py SERVER
"""

import asyncio
import json
import sys
import tempfile
import unittest
from contextlib import asynccontextmanager

import cbor2
import websockets

SERVER = sys.argv.pop(1)
PATIENCE = 30  # s


class Rejected(Exception):
    def __init__(self, message):
        super().__init__(f"{message['code']}: {message['reason']}")
        self.code = message["code"]
        self.seq = message["seq"]


class Client:
    """One connection, from the page's part A."""

    def __init__(self, socket):
        self.socket = socket
        self.binary = socket.subprotocol == "poolhall.v1.cbor"
        self.seq = 0

    def encode(self, message):
        return cbor2.dumps(message) if self.binary else json.dumps(message)

    def decode(self, data):
        assert isinstance(data, bytes) == self.binary, "text and binary frames are mixed"
        return cbor2.loads(data) if self.binary else json.loads(data)

    async def hear(self):
        return self.decode(await asyncio.wait_for(self.socket.recv(), PATIENCE))

    async def await_type(self, kind):
        """Skips what it does not look for, as the page asks of clients."""
        while (message := await self.hear())["type"] != kind:
            if message["type"] == "reject":
                raise Rejected(message)
        return message

    async def move(self, seat, kind, **fields):
        return await self.command("move", seat=seat, move={"type": kind, **fields})

    async def command(self, kind, **fields):
        """Sends a command and returns its answer: joined, accepted or pong."""
        self.seq += 1
        await self.socket.send(self.encode({"type": kind, "seq": self.seq, **fields}))
        while True:
            message = await self.hear()
            if message.get("seq") != self.seq:
                continue
            if message["type"] == "reject":
                raise Rejected(message)
            return message


class Screen:
    """What a spectator would draw: the scene, moved on by frames, corrected by shot_ended."""

    def __init__(self, scene):
        self.positions = [ball["r"][:2] for ball in scene["balls"]]
        self.events = []
        self.ticks = []

    def show(self, frame):
        self.ticks.append(frame["tick"])
        for ball, x, y in frame["balls"]:
            self.positions[ball] = [x, y]
        self.events += frame["events"]


async def watch_shot(client):
    """Follows one shot; returns its start, what was drawn, and its end."""
    started = await client.await_type("shot_started")
    screen = Screen(started["scene"])
    while (message := await client.hear())["type"] != "shot_ended":
        if message["type"] == "frame":
            assert message["shot"] == started["shot"]
            screen.show(message)
    return started, screen, message


def cue_ball(table):
    state = table["state"]
    return state["scene"]["balls"][state["cue_ball"]]["r"]


def direction_to(table, place):
    cue = cue_ball(table)
    return [place[0] - cue[0], place[1] - cue[1]]


def eight_ball(table):
    return next(ball["r"] for ball in table["state"]["scene"]["balls"] if ball["id"] == "8")


def clear_corner(table):
    """The corner whose line from the cue ball passes farthest from the 8-ball."""
    cloth = table["state"]["scene"]["table"]
    length, width = cloth["length"], cloth["width"]
    eight = direction_to(table, eight_ball(table))

    def distance(corner):
        x, y = direction_to(table, corner)
        return abs(x * eight[1] - y * eight[0]) / (x * x + y * y) ** 0.5 if x * eight[0] + y * eight[1] > 0 else 9

    return max([(sx * length / 2, sy * width / 2) for sx in (-1, 1) for sy in (-1, 1)], key=distance)


@asynccontextmanager
async def server():
    with tempfile.TemporaryDirectory(prefix="poolhall-e2e-") as data:
        process = await asyncio.create_subprocess_exec(
            "setpriv", "--pdeathsig", "KILL",  # it ends with this program, whatever happens
            SERVER, "--listen", "127.0.0.1:0", "--data", data,
            stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.DEVNULL)
        try:
            line = await asyncio.wait_for(process.stdout.readline(), PATIENCE)
            assert line.startswith(b"listening on "), line
            yield line.decode().removeprefix("listening on ").strip()
        finally:
            process.terminate()
            assert await asyncio.wait_for(process.wait(), PATIENCE) == 0


@asynccontextmanager
async def connection(address, *subprotocols):
    async with websockets.connect(f"ws://{address}/ws", subprotocols=subprotocols or None) as socket:
        client = Client(socket)
        welcome = await client.hear()
        assert welcome["type"] == "welcome" and welcome["protocol"] == 1, welcome
        yield client


class IndependentClientTest(unittest.IsolatedAsyncioTestCase):
    def check_shot(self, seen, shooter):
        """What the page promises of every shot."""
        started, screen, ended = seen
        self.assertEqual(shooter, started["seat"])
        self.assertEqual(started["shot"], ended["shot"])
        self.assertRegex(started["scene_hash"], r"^[0-9a-f]{16}$")
        self.assertNotIn("final_hash", started)
        self.assertEqual(sorted(set(screen.ticks)), screen.ticks)
        self.assertEqual(ended["ticks"], screen.ticks[-1])
        times = [event["t"] for event in screen.events]
        self.assertEqual(sorted(times), times)
        self.assertEqual("strike", screen.events[0]["kind"])
        for shown, ball in zip(screen.positions, ended["balls"]):
            self.assertAlmostEqual(shown[0], ball["r"][0], places=4)
            self.assertAlmostEqual(shown[1], ball["r"][1], places=4)
        pocketed = [ball["motion"] == "pocketed" for ball in ended["balls"]]
        sunk = [event["balls"][0] for event in screen.events if event["kind"] == "ball_pocket"]
        self.assertEqual(sorted(sunk), [index for index, down in enumerate(pocketed) if down])
        over = "winner" in ended["ruling"]
        self.assertEqual("over" if over else "aiming", ended["table"]["phase"])
        self.assertEqual(over, ended["table"]["state"]["over"])
        self.assertEqual(over, "shoot" not in ended["table"]["legal"])
        self.assertEqual(ended["ruling"], ended["table"]["ruling"])

    async def shoot(self, clients, table, place):
        """The seat whose turn it is shoots at `place`; all see the same. Returns the table after it."""
        shooter = table["legal"]["seat"]
        self.assertEqual(table["state"]["turn"], shooter)
        self.assertIn("shoot", table["legal"])
        watching = [asyncio.create_task(watch_shot(client)) for client in clients if client is not clients[shooter]]
        answer = await clients[shooter].move(shooter, "shoot", strike={"direction": direction_to(table, place)})
        self.assertEqual("accepted", answer["type"])
        seen = await asyncio.gather(watch_shot(clients[shooter]), *watching)
        for each in seen:
            self.check_shot(each, shooter)
            self.assertEqual(seen[0][0], each[0])
            self.assertEqual(seen[0][1].events, each[1].events)
            self.assertEqual(seen[0][2], each[2])
        return seen[0][2]["table"]

    async def play_to_a_scratch(self, clients, table):
        """A shot at the 8-ball while the table allows it, then one into a corner."""
        table = await self.shoot(clients, table, eight_ball(table)[:2])
        if table["phase"] == "aiming":
            loser = table["legal"]["seat"]
            table = await self.shoot(clients, table, clear_corner(table))
            self.assertEqual("scratch", table["ruling"]["verdict"])
            self.assertEqual(1 - loser, table["ruling"]["winner"])
        self.assertEqual("over", table["phase"])
        return table

    async def test_two_players_and_a_spectator_play_a_game_and_a_rematch(self):
        async with (server() as address, connection(address, "poolhall.v1.json") as ann,
                    connection(address, "poolhall.v1.cbor") as bob, connection(address) as wanda):
            joined = await ann.command("create_match", name="Ann")
            code = joined["table"]["code"]
            self.assertEqual("waiting", joined["table"]["phase"])
            spoken = f"{code[:3]}-{code[3:]}".lower()
            joined = await bob.command("join_match", code=spoken, name="Bob")
            self.assertEqual([1], joined["seats"])
            self.assertEqual("aiming", joined["table"]["phase"])
            watching = await wanda.command("watch_match", code=code, name="")
            self.assertEqual(("", []), (watching["token"], watching["seats"]))

            clients = [ann, bob, wanda]
            table = await self.play_to_a_scratch(clients, watching["table"])
            for seat, client in enumerate((ann, bob)):
                await client.move(seat, "agree", what="rematch")
            while table["game_number"] != 2:
                table = (await wanda.await_type("table"))["table"]
            self.assertEqual((1, "aiming"), (table["legal"]["seat"], table["phase"]))
            self.assertEqual({"type": "end_game", "in_hand": True}, table["state"]["part"])
            self.assertIn("place", table["legal"])
            await self.play_to_a_scratch(clients, table)

    async def test_who_creates_a_match_chooses_its_physics(self):
        settings = {"effects": {"sliding": {"mu": 0.2}, "rolling": {}, "spin_decay": {},
                                "ball_ball": {"model": "friction"}, "rail": {"model": "han2005", "e": 0.85}},
                    "solver": {"kind": "event"}}
        async with (server() as address, connection(address, "poolhall.v1.cbor") as ann,
                    connection(address, "poolhall.v1.json") as bob):
            for code, unfit in (("bad_field", {"effects": {}}), ("unknown_field", {"effects": {"wind": {}}}),
                                ("bad_field", {"solver": {"kind": "euler", "hz": 1e9}}), ("bad_field", "event")):
                with self.assertRaises(Rejected) as rejected:
                    await ann.command("create_match", name="Ann", settings=unfit)
                self.assertEqual(code, rejected.exception.code)
            joined = await ann.command("create_match", name="Ann", settings=settings)
            table = (await bob.command("join_match", code=joined["table"]["code"], name="Bob"))["table"]
            scene = table["state"]["scene"]
            effects = scene["effects"]
            self.assertEqual("event", scene["solver"]["kind"])
            self.assertEqual((0.2, 0.01, 0.85), (effects["sliding"]["mu"], effects["rolling"]["mu"], effects["rail"]["e"]))
            self.assertNotIn("linear_drag", effects)
            table = await self.shoot([ann, bob], table, eight_ball(table)[:2])
            self.assertEqual(effects, table["state"]["scene"]["effects"])

    async def test_a_game_is_conceded_and_a_race_is_won(self):
        async with (server() as address, connection(address) as ann, connection(address, "poolhall.v1.cbor") as bob):
            joined = await ann.command("create_match", name="Ann", settings={"race_to": 1, "breaks": "winner"})
            await bob.command("join_match", code=joined["table"]["code"], name="Bob")
            await bob.move(1, "concede")  # not his turn
            table = joined["table"]
            while table["phase"] != "over":
                table = (await ann.await_type("table"))["table"]
            self.assertEqual({"verdict": "conceded", "shooter": 1, "next": 0, "winner": 0, "decided_at": 0},
                             table["ruling"])
            self.assertEqual((0, 0), (table["winner"], table["state"]["winner"]))
            for seat, client in enumerate((ann, bob)):
                await client.move(seat, "agree", what="rematch")
            while table["game_number"] != 2:
                table = (await ann.await_type("table"))["table"]
            self.assertEqual((0, [0, 0]), (table["legal"]["seat"], [seat["wins"] for seat in table["seats"]]))
            self.assertNotIn("winner", table)

    async def test_a_player_places_aims_and_comes_back_with_the_token(self):
        async with server() as address, connection(address, "poolhall.v1.json") as ann:
            joined = await ann.command("create_match", name="Ann", stream="states")
            self.assertEqual("accepted", (await ann.command("take_seat", seat=1))["type"])
            table = (await ann.await_type("table"))["table"]
            region = table["legal"]["place"]
            place = [region["low"][0], 0.1]
            self.assertLess(region["low"][1], place[1])
            self.assertLess(place[1], region["high"][1])
            await ann.command("aim", seat=0, direction=[1, 0.5], cue=place)
            aim = await ann.await_type("aim")
            self.assertEqual(([1, 0.5], place), (aim["direction"], aim["cue"]))
            await ann.move(0, "place", position=place)
            while cue_ball(table)[:2] != place:
                table = (await ann.await_type("table"))["table"]
            self.assertEqual((0, 0), (table["legal"]["seat"], table["state"]["shots"]))
            self.assertNotIn("cue", table)
            await ann.command("aim", seat=0, direction=[1, 0.5])
            self.assertEqual("pong", (await ann.command("ping"))["type"])

            async with connection(address, "poolhall.v9.json", "poolhall.v1.cbor") as back:
                resumed = await back.command("resume", code=joined["table"]["code"], token=joined["token"])
                self.assertEqual([0, 1], resumed["seats"])
                self.assertEqual([1, 0.5], resumed["table"]["aim"])
                await ann.await_type("closing")
                with self.assertRaises(websockets.ConnectionClosed) as closed:
                    await ann.hear()
                self.assertEqual(1008, closed.exception.rcvd.code)
                await back.command("leave")

    async def test_what_the_page_says_is_rejected_is_rejected(self):
        async with server() as address, connection(address) as ann:
            shot = {"type": "shoot", "strike": {"direction": [1, 0]}}
            with self.assertRaises(Rejected) as rejected:
                await ann.command("move", seat=0, move=shot)
            self.assertEqual("not_in_match", rejected.exception.code)
            await ann.command("create_match", name="Ann")
            for code, kind, fields in (
                    ("wrong_phase", "move", {"seat": 0, "move": shot}),
                    ("not_your_seat", "move", {"seat": 1, "move": shot}),
                    ("bad_field", "move", {"seat": 0, "move": {"type": "shoot", "strike": {"direction": [0, 0]}}}),
                    ("missing_field", "move", {"seat": 0}),
                    ("missing_field", "move", {"seat": 0, "move": {"type": "shoot"}}),
                    ("unknown_field", "move", {"seat": 0, "move": {"type": "concede", "more": 1}}),
                    ("unknown_type", "move", {"seat": 0, "move": {"type": "dance"}}),
                    ("unknown_field", "ping", {"more": 1}),
                    ("unknown_type", "dance", {}),
                    ("already_in_match", "create_match", {"name": "Ann"}),
                    ("seat_taken", "take_seat", {"seat": 0})):
                with self.assertRaises(Rejected) as rejected:
                    await ann.command(kind, **fields)
                self.assertEqual((code, ann.seq), (rejected.exception.code, rejected.exception.seq))
            await ann.command("take_seat", seat=1)
            for code, seat, move in (
                    ("not_your_turn", 1, shot),
                    ("wrong_phase", 0, {"type": "agree", "what": "rematch"}),
                    ("illegal", 0, {"type": "place", "position": [0.5, 0.5]}),
                    ("illegal", 0, {"type": "shoot", "strike": {"direction": [1, 0], "speed": 1}}),
                    ("illegal", 0, {"type": "time_out"})):
                with self.assertRaises(Rejected) as rejected:
                    await ann.command("move", seat=seat, move=move)
                self.assertEqual((code, ann.seq), (rejected.exception.code, rejected.exception.seq), move)
            ann.seq -= 1
            with self.assertRaises(Rejected) as rejected:
                await ann.command("ping")
            self.assertEqual("stale_seq", rejected.exception.code)
            await ann.socket.send(b"binary")
            await ann.await_type("closing")
            with self.assertRaises(websockets.ConnectionClosed) as closed:
                await ann.hear()
            self.assertEqual(1003, closed.exception.rcvd.code)

    async def test_unknown_subprotocols_are_refused(self):
        async with server() as address:
            with self.assertRaises(websockets.InvalidHandshake) as refused:
                async with connection(address, "poolhall.v9.json"):
                    pass
            # The library has changed where it keeps the status.
            status = getattr(refused.exception, "status_code", None) or refused.exception.response.status_code
            self.assertEqual(400, status)


if __name__ == "__main__":
    unittest.main(verbosity=2)
