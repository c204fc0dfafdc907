(SOURCE set-up sheet of g31: inputs that answer, a probe that takes time to start.  The programs have the habits)
(SOURCE of probing suites: switch on, wait for the ready input, alarm when it does not come)
(START Z = 200)

(CASE switched on and waited for with a dwell)
(CONTROL fanuc-16i fanuc-30i haas)
(SHEET [probe])
(SHEET on = "M80")
(SHEET off = "M81")
(SHEET ready_input = 1004)
(SHEET start_up_s = 0.5)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
#101=0
M80
WHILE[#1004EQ0]DO1
G04 X0.1
#101=#101+1
END1
G31 Z100. F100.
#100=#5063
G00 Z200.
M81
#102=#1004
M30
%
(EXPECT #100 = 123)
(EXPECT #101 = 5)
(EXPECT #102 = 0)
(EXPECT NO WARNING PRB312)

(CASE waited for without a dwell: looking takes time)
(CONTROL fanuc-16i fanuc-30i haas)
(SHEET [probe])
(SHEET on = "M80")
(SHEET ready_input = 1004)
(SHEET start_up_s = 0.5)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
M80
WHILE[#1004EQ0]DO1
END1
G31 Z100. F100.
#100=#5063
M30
%
(EXPECT #100 = 123)
(EXPECT NO WARNING PRB312)

(CASE measured too early: no signal can come)
(CONTROL fanuc-16i fanuc-30i haas)
(SHEET [probe])
(SHEET on = "M80")
(SHEET start_up_s = 0.5)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
M80
G04 X0.4
G31 Z150. F60000.
G04 X0.2
G31 Z100. F100.
#100=#5063
M30
%
(EXPECT #100 = 123)
(EXPECT WARNING PRB312 AT 11)

(CASE a suite that finds the probe off says so)
(SHEET [probe])
(SHEET on = "M80")
(SHEET ready_input = 1004)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
M81
G04 X1.
IF[#1004EQ1]GOTO10
#3000=1(PROBE NOT ON)
N10 G31 Z100. F100.
M30
%
(EXPECT ALARM 3001 AT 11)
(EXPECT MESSAGE "PROBE NOT ON")

(CASE an output switches it on, and off again)
(CONTROL fanuc-16i fanuc-30i haas)
(SHEET [probe])
(SHEET on = "#1103")
(SHEET ready_input = 1004)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
#100=#1004
#1103=1
#101=#1004
#1132=0
#102=#1004
#1132=8
#103=#1004
#1103=0
#104=#1004
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 1)
(EXPECT #102 = 0)
(EXPECT #103 = 1)
(EXPECT #104 = 0)

(CASE an input from a time on, and another from a block)
(CONTROL fanuc-16i fanuc-30i haas)
(SHEET [[input]])
(SHEET number = 1003)
(SHEET from_s = 2.5)
(SHEET [[input]])
(SHEET number = 1007)
(SHEET from_block = 8)
%
O1
#100=#1003
G04 X2.
#101=#1003
G04 X1.
#102=#1003
#103=#1007
#104=#1007
#105=#1032
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 0)
(EXPECT #102 = 1)
(EXPECT #103 = 0)
(EXPECT #104 = 1)
(EXPECT #105 = 136)

(CASE an input at the third look, and back at the fifth)
(CONTROL fanuc-16i fanuc-30i haas)
(SHEET [[input]])
(SHEET number = 1003)
(SHEET from_reads = 3)
(SHEET [[input]])
(SHEET number = 1003)
(SHEET value = 0)
(SHEET from_reads = 5)
%
O1
#101=#1003
#102=#1003
#103=#1003
#104=#1003
#105=#1003
M30
%
(EXPECT #101 = 0)
(EXPECT #102 = 0)
(EXPECT #103 = 1)
(EXPECT #104 = 1)
(EXPECT #105 = 0)

(CASE an input that M codes set and reset as often as they come)
(CONTROL fanuc-16i fanuc-30i haas)
(SHEET [[input]])
(SHEET number = 1003)
(SHEET from_code = "M21")
(SHEET [[input]])
(SHEET number = 1003)
(SHEET value = 0)
(SHEET from_code = "M22")
%
O1
#101=#1003
M21
#102=#1003
M22
#103=#1003
M21
#104=#1003
M30
%
(EXPECT #101 = 0)
(EXPECT #102 = 1)
(EXPECT #103 = 0)
(EXPECT #104 = 1)

(CASE a handshake: an output asks, the machine answers after a while)
(CONTROL fanuc-16i fanuc-30i haas)
(SHEET [[input]])
(SHEET number = 1002)
(SHEET from_s = 1.5)
%
O1
#1101=1
WHILE[#1002NE1]DO1
END1
#1101=0
#100=#3001
IF[#100LT1500]GOTO90
IF[#100GT1502]GOTO90
#101=1
N90 M30
%
(EXPECT #101 = 1)

(CASE a low battery shows on its input)
(SHEET [probe])
(SHEET state = "low_battery")
(SHEET low_battery_input = 1006)
(SHEET [[part]])
(SHEET shape = "cylinder")
%
O1
IF[#1006EQ0]GOTO10
#3000=2(BATTERY LOW)
N10 G31 Z100. F100.
M30
%
(EXPECT ALARM 3002 AT 9)
(EXPECT MESSAGE "BATTERY LOW")

(CASE all inputs at once are one look: a hundred take no time, the next and that at the clock 1 ms each)
(CONTROL fanuc-16i fanuc-30i haas)
(SHEET [[input]])
(SHEET number = 1000)
(SHEET from_reads = 101)
%
O1
#3001=0
WHILE[#1032EQ0]DO1
#101=#101+1
END1
#102=#3001
M30
%
(EXPECT #101 = 100)
(EXPECT #102 = 2)

(CASE a displacement sensor in an input word counts its resolution; without one 0.0001 mm)
(CONTROL fanuc-16i fanuc-30i)
(SHEET [[part]])
(SHEET shape = "block")
(SHEET [[sensor]])
(SHEET at = [0.0, 0.0, -150.0])
(SHEET range = 60.0)
(SHEET resolution = 0.002)
(SHEET word = 1033)
(SHEET [[sensor]])
(SHEET at = [10.0, 0.0, -151.0])
(SHEET range = 60.0)
%
O1
#101=#1033
#102=#1133
G0 X25.
#103=#1033
#104=#1133
M30
%
(EXPECT #101 = 25000)
(EXPECT #102 = 490000)
(EXPECT #103 = 25000)
(EXPECT #104 = 600000)
