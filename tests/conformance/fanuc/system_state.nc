(Alarms, timers, settings, ports, offsets by variables: MB-120 to MB-132.)

(CASE MB-120 reading what can only be written, 16i)
(CONTROL fanuc-16i)
%
O1
#100=#3000
M30
%
(EXPECT ALARM 115 AT 4)

(CASE MB-120 reading what can only be written, 30i)
(CONTROL fanuc-30i)
%
O1
#100=#3006
M30
%
(EXPECT ALARM 1115 AT 4)

(CASE MB-120 #1000 can only be read)
%
O1
#1000=1
M30
%
(EXPECT ALARM 116 AT 3)

(CASE MB-120 #5001 can only be read)
%
O1
#5001=1
M30
%
(EXPECT ALARM 116 AT 3)

(CASE MB-120 #5061 can only be read)
%
O1
#5061=1
M30
%
(EXPECT ALARM 116 AT 3)

(CASE MB-120 #4001 can only be read)
%
O1
#4001=1
M30
%
(EXPECT ALARM 116 AT 3)

(CASE MB-120 #5021 can only be read)
%
O1
#5021=1
M30
%
(EXPECT ALARM 116 AT 3)

(CASE MB-120 #3011 can only be read)
%
O1
#3011=1
M30
%
(EXPECT ALARM 116 AT 3)

(CASE MB-120 #3007 can only be read)
%
O1
#3007=1
M30
%
(EXPECT ALARM 116 AT 3)

(CASE MB-121 outputs: the word sets the bits)
%
O1
#1132=5
#100=#1100
#101=#1101
#102=#1102
#103=#1132
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 0)
(EXPECT #102 = 1)
(EXPECT #103 = 5)

(CASE MB-121 the bits make the word; anything but 0 is 1)
%
O1
#1100=1
#1103=7.5
#1104=-1
#1105=0
#1106=#0
#100=#1132
#101=#1103
M30
%
(EXPECT #100 = 25)
(EXPECT #101 = 1)

(CASE MB-121 32-bit words are signed)
%
O1
#1133=-2
#100=#1133
M30
%
(EXPECT #100 = -2)

(CASE MB-121 inputs are 0 at a desk)
%
O1
#100=#1000
#101=#1015
#102=#1032
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 0)
(EXPECT #102 = 0)

(CASE MB-122 memory C: H geometry, H wear, D wear, D geometry)
%
O1
#2001=0.1
#2201=100.
#12001=0.2
#13001=5.
#100=#10001
#101=#11001
#10002=0.3
#11002=50.
#102=#2002
#103=#2202
G43 H1 G0 Z0
#104=#5083
M30
%
(EXPECT #100 = 0.1)
(EXPECT #101 = 100)
(EXPECT #102 = 0.3)
(EXPECT #103 = 50)
(EXPECT #104 = 100.1)

(CASE MB-122 6000.3 turns the families)
(PARAMETER 6000.3 = 1)
%
O1
#2001=100.
#2201=0.1
#2401=5.
#2601=0.2
#100=#11001
#101=#10001
#102=#13001
#103=#12001
M30
%
(EXPECT #100 = 100)
(EXPECT #101 = 0.1)
(EXPECT #102 = 5)
(EXPECT #103 = 0.2)

(CASE MB-122 above 200 only the five-digit numbers)
%
O1
#11201=7.
#100=#11201
#101=#2200
#102=#2201
M30
%
(EXPECT #100 = 7)
(EXPECT #101 = 0)
(EXPECT #102 = 0)

(CASE MB-122 memory B: wear and geometry)
(SETTING offset_memory = "B")
%
O1
#2001=1.
#2201=2.
#100=#10001
#101=#11001
M30
%
(EXPECT #100 = 1)
(EXPECT #101 = 2)

(CASE MB-122 an active offset that is written acts from the next block with its H)
%
O1
#11005=10.
G43 H5 G0 Z0
#11005=20.
G43 H5 Z0
M30
%
(EXPECT MOVE 1 Z10)
(EXPECT MOVE 2 Z20)

(CASE MB-123 a macro alarm)
%
O1
#500=1
#3000=21(NO CONTACT)
#500=2
M30
%
(EXPECT ALARM 3021 AT 4)
(EXPECT MESSAGE "NO CONTACT")
(EXPECT #500 = 1)

(CASE MB-123 the largest number of the 16i)
(CONTROL fanuc-16i)
%
O1
#3000=200(X)
M30
%
(EXPECT ALARM 3200 AT 4)

(CASE MB-123 the largest of the 30i)
(CONTROL fanuc-30i)
%
O1
#3000=4095(X)
M30
%
(EXPECT ALARM 7095 AT 4)

(CASE MB-123 6008.1 shows the number itself)
(CONTROL fanuc-30i)
(PARAMETER 6008.1 = 1)
%
O1
#3000=77(X)
M30
%
(EXPECT ALARM 77 AT 5)

(CASE MB-123 a computed number and no text)
%
O1
#1=3
#3000=100+#1
M30
%
(EXPECT ALARM 3103 AT 4)

(CASE MB-123 behind a skipped block nothing stops)
(SETTING block_skip = [1])
%
O1
/#3000=1(X)
#100=1
M30
%
(EXPECT #100 = 1)

(CASE MB-124 a stop with a message goes on)
%
O1
#3006=1(TURN THE PART)
#100=1
M30
%
(EXPECT STOP "TURN THE PART")
(EXPECT #100 = 1)

(CASE MB-125 the timer is writable and counts milliseconds of machine time)
%
O1
#3001=0
G4 P2500
#100=#3001
#3001=1000
G4 X1.5
#101=#3001
M30
%
(EXPECT #100 = 2500 WITHIN 1)
(EXPECT #101 = 2500 WITHIN 1)

(CASE MB-125 hours of cycle start)
%
O1
#3002=0
G4 X1800.
#100=#3002
M30
%
(EXPECT #100 = 0.5 WITHIN 0.001)

(CASE MB-125 it does not stand still while axes move)
%
O1
#3001=0
G1 X100. F6000.
#100=#3001
M30
%
(EXPECT #100 = 1000 WITHIN 100)

(CASE MB-126 date and time are numbers, so a leading zero is lost)
(SET #3011 = 20220915)
(SET #3012 = 91025)
%
O1
#100=#3011
#101=#3012
G4 X35.
#102=#3012
M30
%
(EXPECT #100 = 20220915)
(EXPECT #101 = 91025)
(EXPECT #102 = 91100)

(CASE MB-127 #3003 and #3004 are 0 at power on and keep what is written)
%
O1
#100=#3003
#101=#3004
#3003=3
#3004=7
#102=#3003
#103=#3004
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 0)
(EXPECT #102 = 3)
(EXPECT #103 = 7)

(CASE MB-129 settings: bit 2 of #3005 is inch)
%
O1
#100=#3005 AND 4
G20
#101=#3005 AND 4
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 4)

(CASE MB-130 no axis is mirrored by a switch)
%
O1
#100=#3007
G51.1 X0
#101=#3007
M30
%
(EXPECT #100 = 0)
(EXPECT #101 = 0)

(CASE MB-131 parts counters)
%
O1
#3901=5
#3902=10
#3901=#3901+1
#100=#3901
#101=#3902
M30
%
(EXPECT #100 = 6)
(EXPECT #101 = 10)

(CASE MB-132 #3008 is not there)
(CONTROL fanuc-16i)
%
O1
#100=#3008
M30
%
(EXPECT ALARM 115 AT 4)

(CASE MB-132 #3009 is not there)
%
O1
#100=#3009
M30
%
(EXPECT ALARM 115 AT 3)

(CASE MB-132 #3010 is not there)
%
O1
#100=#3010
M30
%
(EXPECT ALARM 115 AT 3)

(CASE MB-132 #3013 is not there)
%
O1
#100=#3013
M30
%
(EXPECT ALARM 115 AT 3)

(CASE MB-132 #3099 is not there)
%
O1
#100=#3099
M30
%
(EXPECT ALARM 115 AT 3)

(CASE MB-132 #3200 is not there)
%
O1
#100=#3200
M30
%
(EXPECT ALARM 115 AT 3)

(CASE MB-132 #3899 is not there)
%
O1
#100=#3899
M30
%
(EXPECT ALARM 115 AT 3)

(CASE MB-125 a program that only looks at the clock waits for it)
%
O1
#3001=0
WHILE[#3001LT500]DO1
END1
#100=#3001
M30
%
(EXPECT #100 = 501 WITHIN 2)

(CASE MB-125 so does one that waits for a signal, with a time-out)
%
O1
#3001=0
WHILE[#1004EQ0]DO1
IF[#3001GT2000]GOTO90
END1
M30
N90#3000=12(NO SIGNAL)
%
(EXPECT ALARM 3012 AT 8)
(EXPECT MESSAGE "NO SIGNAL")

(CASE MB-007 of two comments the one directly behind the number is the text)
%
O1
#1=1
#3000=#1+90 (NO CONTACT) (SEE SHEET 4)
M30
%
(EXPECT ALARM 3091 AT 4)
(EXPECT MESSAGE "NO CONTACT")

(CASE INI: with parameter 0.2 the control starts in inches)
(SOURCE Fanuc 0i-MD parameter manual, No. 0: INI, unit of input, 1 in inches)
(PARAMETER 0.2 = 1)
%
O1
#100=#4006
#101=#3005
G90 G54 G00 X1.
G21
#102=#5021
#103=#3005
M30
%
(EXPECT #100 = 20)
(EXPECT #101 = 4)
(EXPECT #102 = 25.4)
(EXPECT #103 = 0)

(CASE a Brother without G20 and G21, too)
(CONTROL brother)
(PARAMETER 0.2 = 1)
%
O1
#100=#4006
#5221=1.
G90 G54 G00 X0
#101=#5021
M30
%
(EXPECT #100 = 20)
(EXPECT #101 = 1)

(CASE G10 L52 writes parameter 0, and with it the unit)
(CONTROL fanuc-30i)
%
O1
G10 L52
N0 R00000100
G11
#100=#4006
#101=PRM[0,2]
G10 L52
N0 R00000000
G11
#102=#4006
M30
%
(EXPECT #100 = 20)
(EXPECT #101 = 1)
(EXPECT #102 = 21)

(CASE G10 L50 without N knows no parameter)
(CONTROL fanuc-30i)
%
O1
G10 L50
R00000100
G11
M30
%
(EXPECT ALARM 1144 AT 5)

(CASE of a Haas setting 9 is the unit that the control starts in)
(CONTROL haas)
(SET #20009 = 0)
(SET #14001 = 1)
%
O1
#100=#4006
#101=#20009
#102=#6009
G90 G154 P1 G00 X0.
#103=#5021
M30
%
(EXPECT MOVE 1 X25.4)
(EXPECT #100 = 20)
(EXPECT #101 = 0)
(EXPECT #102 = 0)
(EXPECT #103 = 1)

(CASE of a Haas setting 9 agrees with the unit where only parameter 0.2 says it)
(CONTROL haas)
(PARAMETER 0.2 = 1)
%
O1
#100=#20009
M30
%
(EXPECT #100 = 0)

(CASE of a Haas setting 9 is millimetres where nothing says so)
(CONTROL haas)
%
O1
#100=#20009
M30
%
(EXPECT #100 = 1)
